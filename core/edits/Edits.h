// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace core {

// Edits are plain data: what the user did, in the patient's millimetres and modality units, with no
// pointer and nothing left to be read elsewhere. Recipe, session file and replay share this form.
// Numbers that decide voxels are rounded once by quantised() (EditQuantise.h).

struct AddSegment {
    QString name{};
    std::uint32_t rgb = 0;
    CodedConcept code{};
};

/// Rename, recolour, code or lock a segment; absent fields stay.
struct ChangeSegment {
    int segment = 0; ///< label
    std::optional<QString> name{};
    std::optional<std::uint32_t> rgb{};
    std::optional<CodedConcept> code{};
    std::optional<bool> locked{};
};

/// Put a segment at another place of the list.
struct MoveSegment {
    int segment = 0; ///< label
    int place = 0; ///< 1: first; beyond the end: last
};

/// Sketched seeds: the voxels nearest to these points.
struct SeedStroke {
    int segment = 0;
    std::vector<glm::dvec3> pointsLps{};
};

struct GrowSteps {
    double lower = 0.0; ///< modality units, inclusive
    double upper = 0.0;
    int connectivity = 6;
    std::optional<int> steps{}; ///< none: to closure
    bool overwriteUnlocked = false;
};

/// An orthographic camera; a perspective one is converted at the picked depth.
struct OrthographicView {
    glm::dvec3 eyeLps{0.0};
    glm::dvec3 targetLps{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double heightMm = 300.0; ///< what the view shows; decides no voxel
};

struct PenSample {
    double xMm = 0.0; ///< in the view plane, right of the target
    double yMm = 0.0; ///< up from the target
    double pressure = 1.0; ///< 0 … 1
    double tSeconds = 0.0;
};

struct DrillStroke {
    int layer = 1;
    OrthographicView view{};
    double radiusMm = 8.0; ///< circle
    double depthMm = 8.0; ///< at full pressure
    int pressureExponent = 2;
    double surfaceThreshold = 0.0; ///< modality units: what is seen
    bool throughGaps = false;
    std::vector<PenSample> samples{};
};

/// "Undo only here": takes back older rows of the history and leaves what came after them. Their
/// bricks must not have been written or read since (session/RowReach.h).
struct RevertRows {
    std::vector<std::int64_t> rows{}; ///< RowId, ascending
};

using Edit = std::variant<AddSegment, ChangeSegment, MoveSegment, SeedStroke, GrowSteps,
    DrillStroke, RevertRows>;

} // namespace core
