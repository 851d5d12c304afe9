// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

#include <QByteArray>
#include <QString>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

struct LabelPlanes;

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
[[nodiscard]] Result<EngineEdit> engineEdit(const ImportMask& edit, const Document& document);

/// Errors: those of importTargets(), InvalidField (voxels that cannot be unpacked, or of another
/// grid).
[[nodiscard]] Result<LabelPlanes> labelPlanes(const ImportMask& edit, const Document& document);

} // namespace core
