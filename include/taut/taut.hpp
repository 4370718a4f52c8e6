// All of taut's public interface.
#pragma once

#include "taut/adapt.hpp"
#include "taut/error.hpp"
#include "taut/field.hpp"
#include "taut/geometry.hpp"
#include "taut/gradation.hpp"
#include "taut/host.hpp"
#include "taut/io.hpp"
#include "taut/levelset.hpp"
#include "taut/limits.hpp"
#include "taut/local_sizes.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"
#include "taut/motion.hpp"
#include "taut/placing.hpp"
#include "taut/quality.hpp"
#include "taut/ridges.hpp"
#include "taut/rigid_motion.hpp"
#include "taut/sizing.hpp"
#include "taut/solution.hpp"
#include "taut/space_time.hpp"
#include "taut/surface.hpp"
#include "taut/surface_distance.hpp"
#include "taut/surface_mesh.hpp"
#include "taut/threads.hpp"
#include "taut/transfer.hpp"
#include "taut/unsteady.hpp"
#include "taut/version.hpp"

/// Anisotropic tetrahedral mesh adaptation: adapt() is where to begin.
namespace taut {}
