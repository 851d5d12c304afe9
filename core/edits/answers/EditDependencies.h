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
struct EditableRange;

/// What is known of how a row was carried out, in addition to its edit.
struct RowTrace {
    /// EditStatistics::searchedTo; none: a cut may have read the whole volume.
    std::optional<std::int32_t> searchedTo{};
    /// For a growth: the bricks in which it may have read labels, which is where seed words were or
    /// came, and next to them. None: anywhere.
    std::optional<std::set<std::uint32_t>> grownBeside{};
    /// For an import: the bricks that it has voxels in. None: anywhere. To find them all its voxels
    /// are unpacked, which is not for the thread of a window (core/session/past/ImportTrace.h).
    std::optional<std::set<std::uint32_t>> importedTo{};
};

/// The forms that a set of dependencies can have.
namespace dependsOn {

struct Bricks {
    std::set<BrickKey> keys;
};
/// All seed words and labels of a plane.
struct Plane {
    std::optional<std::uint8_t> plane{}; ///< none: of all planes
};
/// Labels and seed words of all planes in some bricks, and what was written.
struct AllPlanes {
    std::set<std::uint32_t> bricks;
    std::set<BrickKey> written;
};
/// All seed words of a plane, and labels (with `coverage` that too) in some bricks.
struct SeedWords {
    std::uint8_t plane = 0;
    bool coverage = false;
    std::set<std::uint32_t> beside;
};
/// Whole fields.
struct Fields {
    std::optional<std::uint8_t> plane; ///< labels and seed words
    std::bitset<256> layers; ///< coverage
};
/// The volume in front of the path of a mask, in the plane of a cut's view.
struct SweptToolMask {
    glm::dvec3 origin{0.0}; ///< of voxel (0, 0, 0), mm
    glm::dmat3 perVoxel{0.0}; ///< mm
    BrickGrid grid;
    std::bitset<256> labels; ///< the planes whose labels are read
    std::vector<glm::dvec2> path; ///< mm
    double reachMm = 0.0; ///< from the path to the farthest place that is read
    double endMm = 0.0; ///< nothing behind this is read
};

using Any = std::variant<Bricks, Plane, AllPlanes, SeedWords, SweptToolMask, Fields>;

} // namespace dependsOn

/// The bricks on which the result of a row depends, including those that it wrote
/// (core/session/past/RowDependencies.h).
struct EditDependencies : dependsOn::Any {
    using dependsOn::Any::variant;
    std::bitset<256> labelPlanes{}; ///< planes whose labels are read as well, in the whole volume
};

/// What such a set is computed from, in addition to the edit.
struct DependencyFacts {
    const Document& document; ///< as it was when the row was carried out
    const std::vector<BrickKey>& written; ///< bricks that the row changed
    const RowTrace& trace;

    [[nodiscard]] const VolumeGeometry& geometry() const;
    [[nodiscard]] BrickGrid grid() const;
    /// The plane of a label; the first plane if there is no such segment.
    [[nodiscard]] std::uint8_t planeOf(int label) const;

    /// For an edit that writes no voxel, or only those that it takes back or combines anew.
    [[nodiscard]] EditDependencies whatWasWritten() const;
    /// The bricks under a brush; none if they cannot be computed.
    [[nodiscard]] std::set<std::uint32_t> under(const BrushPath& path) const;
    /// All fields of a label plane (labels, seed words, …) in some bricks, or under a brush.
    [[nodiscard]] EditDependencies labelled(
        const std::set<std::uint32_t>& bricks, std::uint8_t plane) const;
    [[nodiscard]] EditDependencies labelled(const BrushPath& path, std::uint8_t plane) const;
    /// Adds to what an edit reads the segments that its editable range lists: in the same bricks if
    /// the edit is limited to some, otherwise in their whole planes.
    [[nodiscard]] EditDependencies alsoReading(
        const std::optional<EditableRange>& range, EditDependencies own) const;
};

} // namespace core
