// What a shared library of taut shows. All else is hidden, so that it may change without notice.
#pragma once

/// Marks a function that programs may call, or a class that they may catch.
#define TAUT_EXPORT __attribute__((visibility("default")))
