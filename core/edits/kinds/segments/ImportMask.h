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

struct LabelListed;

/// A segment of a mask that was read from a file.
struct ImportedSegment {
    QString name{};
    std::uint32_t rgb = 0;
    CodedConcept code{};
    QByteArray voxels{}; ///< packedRuns() (core/brick/VoxelRuns.h), on the volume's grid
};

/// A segment by the number or the name that a recipe has for it.
struct SegmentWord {
    std::optional<int> number{}; ///< label; none: the name says it
    QString name{};
};

/// The segments of a mask's file become segments here. An edit that is carried out holds their
/// voxels and needs the file no more; one that has none yet is completed by core/masks first. Where
/// segments overlap, the first one has the voxel.
struct ImportMask {
    QString file{};
    std::optional<SegmentWord> as{}; ///< the one that receives all of it; none: new ones
    bool overwriteUnlocked = false;
    std::optional<glm::ivec3> size{}; ///< of the volume
    std::optional<std::vector<ImportedSegment>> segments{};
};

[[nodiscard]] Result<void> check(const ImportMask& edit, const Document& document);
Result<bool> apply(const ImportMask& edit, Document& document);
[[nodiscard]] EditEffects effects(const ImportMask& edit);
[[nodiscard]] RowTitle rowTitle(const ImportMask& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const ImportMask& edit, const ReachFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const ImportMask& edit, const Document& document);

/// Errors: those of importTargets(), InvalidField (voxels that are none, or of another grid).
[[nodiscard]] Result<LabelListed> labelListed(const ImportMask& edit, const Document& document);

} // namespace core
