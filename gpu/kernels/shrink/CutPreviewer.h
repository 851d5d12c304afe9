// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/TaskThread.h"
#include "core/engine/GrowthForesight.h"
#include "gpu/kernels/shrink/PreviewMarks.h"

#include <memory>
#include <optional>

namespace gpu {

class VolumeTextures;
class VoxelFields;

/// Foresees what a cut of a growth would remove (core/growth/cut/GrowthCut.h) while the pen is
/// down. The seed words are read back once, in slices, and kept until something changes. The answer
/// is computed on a thread of its own, so that neither strokes nor pictures wait. Pictures show the
/// latest answer. Engine thread only.
class CutPreviewer {
public:
    /// @param textures outlive this
    explicit CutPreviewer(VolumeTextures& textures);
    ~CutPreviewer();
    CutPreviewer(const CutPreviewer&) = delete;
    CutPreviewer& operator=(const CutPreviewer&) = delete;

    /// @param question about a valid cut
    /// @return none while the answer is being computed. Errors: as those of the cut.
    [[nodiscard]] core::Result<std::optional<core::CutPreview>> ask(
        VoxelFields& fields, const core::PreviewCut& question);
    /// Drops everything, because the seed words are about to change or nobody asks any more. Does
    /// not wait.
    void forget();
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Ground; ///< the seed words and labels that were read back
    struct Work; ///< a question and its answer

    /// @return whether everything has been read
    [[nodiscard]] bool read(VoxelFields& fields, std::uint8_t plane, bool toTheEnd);
    void post();
    void show(VoxelFields& fields);

    std::shared_ptr<Ground> m_ground;
    std::shared_ptr<Work> m_work; ///< the latest question
    std::optional<core::CutPreview> m_answer; ///< its answer; none if the cut is refused
    std::optional<core::Error> m_refused; ///< the reason
    PreviewMarks m_marks;
    std::optional<core::TaskThread> m_worker; ///< started with the first question
};

} // namespace gpu
