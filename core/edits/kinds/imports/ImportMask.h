// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <QByteArray>
#include <QString>

#include <glm/glm.hpp>

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// A segment of a mask that was read from a file.
struct ImportedSegment {
    QString name{};
    std::uint32_t rgb = 0;
    CodedConcept code{};
    QByteArray voxels{}; ///< packedRuns() (core/brick/VoxelRuns.h), on the volume's grid
};

/// A segment, by the number or the name that a recipe gives.
struct SegmentWord {
    std::optional<int> number{}; ///< label; none: use the name
    QString name{};
};

/// Make the segments of a mask file segments of the session. An edit that was carried out contains
/// their voxels and no longer needs the file; core/masks completes one without voxels first. Where
/// segments of one plane overlap, the first one gets the voxel (segmentsByPrecedence()).
///
/// It takes no voxel from segments that existed before, in whatever plane they have it. With
/// overwriteUnlocked, those that are not locked lose it in their own planes.
struct ImportMask {
    QString file{};
    std::optional<SegmentWord> as{}; ///< the segment that receives everything; none: new ones
    bool overwriteUnlocked = false;
    std::optional<glm::ivec3> size{}; ///< of the volume
    std::optional<std::vector<ImportedSegment>> segments{};
    /// Segments that take precedence over all others, by their place in the list from 1, the
    /// foremost first; none: the order of the list.
    std::optional<std::vector<int>> ahead{};
    /// The label plane of each segment, so that overlapping segments keep all their voxels; none:
    /// all lie in plane 0, or in that of the segment that receives everything.
    std::optional<std::vector<int>> planes{};
};

[[nodiscard]] Result<void> check(const ImportMask& edit, const Document& document);
Result<bool> apply(const ImportMask& edit, Document& document);
[[nodiscard]] EditEffects effects(const ImportMask& edit);
[[nodiscard]] RowTitle rowTitle(const ImportMask& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ImportMask& edit, const DependencyFacts& row);

/// What an import does, apart from its voxels.
struct ImportPlan {
    /// A label plane that it writes to.
    struct Plane {
        std::uint8_t plane = 0;
        std::bitset<256> overwritable{};
        std::optional<EditableVoxels> editable{}; ///< where segments of other planes keep theirs
        bool othersMayLose = false; ///< segments of it that are not locked lose what is imported
    };
    glm::ivec3 size{0};
    std::vector<LabelTarget> targets{}; ///< one for each segment of the import
    std::vector<std::size_t>
        order{}; ///< of the segments; the foremost gets voxels that several have
    std::vector<Plane> planes{}; ///< ascending
    std::uint8_t frees = 0; ///< LabelListed::frees; 0: nobody loses voxels in another plane
};

/// Cost: of the lists of segments alone; no voxel is looked at.
/// Errors: those of importTargets(), InvalidField (voxels of another grid).
[[nodiscard]] Result<ImportPlan> importPlan(const ImportMask& edit, const Document& document);

/// What it writes. Cost: that of all its voxels; it checks @p progress after each segment. Any
/// thread. Errors: InvalidField (voxels that cannot be unpacked), Cancelled.
[[nodiscard]] Result<LabelPlanes> labelPlanes(
    const ImportPlan& plan, const std::vector<ImportedSegment>& segments, const Progress& progress);
/// Both at once.
[[nodiscard]] Result<LabelPlanes> labelPlanes(const ImportMask& edit, const Document& document);

} // namespace core
