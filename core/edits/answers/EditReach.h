// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

#include <glm/glm.hpp>

#include <bitset>
#include <cstdint>
#include <optional>
#include <set>
#include <variant>
#include <vector>

namespace core {

struct BrushPath;

/// What is known of how a row was carried out, beside its edit.
struct RowTrace {
    /// EditStatistics::searchedTo; none: a cut may have looked through the whole volume.
    std::optional<std::int32_t> searchedTo{};
    /// Of a growth: where labels may have been asked for, which is wherever seed words stood or
    /// came, and beside them. None: anywhere.
    std::optional<std::set<std::uint32_t>> grownBeside{};
};

/// The forms that a reach has.
namespace editReach {

struct Bricks {
    std::set<BrickKey> keys;
};
/// All seed words and labels of a plane.
struct Plane {
    std::uint8_t plane = 0;
};
/// All seed words of a plane, and of some bricks more.
struct Growth {
    std::uint8_t plane = 0;
    bool coverage = false;
    std::set<std::uint32_t> beside;
};
/// Whole fields.
struct Fields {
    std::optional<std::uint8_t> plane; ///< labels and seed words
    std::bitset<256> layers; ///< coverage
};
/// In the plane of a cut's view.
struct SweptMask {
    glm::dvec3 origin{0.0}; ///< of voxel (0, 0, 0), mm
    glm::dmat3 perVoxel{0.0}; ///< mm
    BrickGrid grid;
    std::optional<std::uint8_t> labels; ///< the plane whose labels are read, if any is
    std::vector<glm::dvec2> path; ///< mm
    double reachMm = 0.0; ///< from the path to whatever is read
    double endMm = 0.0; ///< nothing is read behind it
};

using Any = std::variant<Bricks, Plane, Growth, SweptMask, Fields>;

} // namespace editReach

/// What the result of a row depends on, bricks it wrote included (core/session/past/RowReach.h).
struct EditReach : editReach::Any {
    using editReach::Any::variant;
};

/// What a reach is told from, beside the edit.
struct ReachFacts {
    const Document& document; ///< as it was when the row was carried out
    const std::vector<BrickKey>& written; ///< bricks that the row changed
    const RowTrace& trace;

    [[nodiscard]] const VolumeGeometry& geometry() const;
    [[nodiscard]] BrickGrid grid() const;
    /// Of a label; the first plane where there is no such segment.
    [[nodiscard]] std::uint8_t planeOf(int label) const;
    [[nodiscard]] std::uint8_t growthPlane() const;

    /// Of what writes no voxel, or only what it took back or folded anew.
    [[nodiscard]] EditReach whatWasWritten() const;
    /// Of growths that take back, plug or show something first: every seed word and label of the
    /// plane.
    [[nodiscard]] EditReach wholeGrowth() const;
    /// The bricks under a brush; none where it could not be worked out.
    [[nodiscard]] std::set<std::uint32_t> under(const BrushPath& path) const;
    /// All that is kept of labels under a brush.
    [[nodiscard]] EditReach labelled(const BrushPath& path, std::uint8_t plane) const;
};

} // namespace core
