#pragma once
#include "mesh/shapes.hpp"
#include "taut/transfer.hpp"
