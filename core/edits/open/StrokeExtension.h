// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/PenSample.h"
#include "core/growth/GrowthProgress.h"

#include <glm/glm.hpp>

#include <variant>
#include <vector>

namespace core {

// The input of an edit that stands open (EditSession::extend()), in LPS millimetres and modality
// units. Each kind of edit takes what applies to it and ignores the rest. GrowAdvance
// (core/growth/GrowthProgress.h) requests further steps of a growth.

/// Further reports of the pen that moves a tool.
struct PenSamples {
    std::vector<PenSample> samples{};
};

/// Further points of the path of a brush, or of a tool of the surface.
struct PathPoints {
    std::vector<glm::dvec3> pointsLps{};
    bool lifted = false; ///< a new path begins at the first of these points (not on a surface)
    /// of the points (PenPressures), for an edit that began with one
    std::vector<double> pressures{};
};

/// Another depth, which replaces the earlier one. It may be greater or smaller.
struct ToDepth {
    double mm = 0.0;
};

/// Another number of steps. Some kinds replace the earlier number, others only add what is missing.
struct ToSteps {
    int steps = 0;
};

/// Another interval of values, as if the edit had begun with it. Steps that were requested before
/// are cancelled.
struct ToInterval {
    double lower = 0.0;
    double upper = 0.0;
};

/// Cancels steps of a growth that were requested and not yet done.
struct PauseGrowth { };

/// Discards what the engine keeps for the next preview of this kind.
struct ForgetPreview { };

using StrokeExtensionVariant = std::variant<PenSamples, PathPoints, ToDepth, ToSteps, ToInterval,
    GrowAdvance, PauseGrowth, ForgetPreview>;

/// Any one of them; a struct, so that headers can name it without knowing them.
struct StrokeExtension : StrokeExtensionVariant {
    using StrokeExtensionVariant::variant;
};

} // namespace core
