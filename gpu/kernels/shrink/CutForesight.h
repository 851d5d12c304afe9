// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/TaskThread.h"
#include "core/engine/EngineCommands.h"
#include "gpu/fields/bricks/BrickField.h"

#include <memory>
#include <optional>
#include <vector>

namespace gpu {

class VolumeTextures;
class VoxelFields;

/// What a cut of a growth would take (core/growth/cut/GrowthCut.h), while the pen is down. The seed
/// words are read back once, in slices, and stay until something changes; a thread of its own works
/// an answer out, so that neither strokes nor pictures wait. What is answered last is lent to
/// pictures. Engine thread only.
class CutForesight {
public:
    /// @param textures outlive this
    explicit CutForesight(VolumeTextures& textures);
    ~CutForesight();
    CutForesight(const CutForesight&) = delete;
    CutForesight& operator=(const CutForesight&) = delete;

    /// @param question of a sound cut @return none: it is being worked out. Errors: as the cut's.
    [[nodiscard]] core::Result<std::optional<core::ForeseenCut>> ask(
        VoxelFields& fields, const core::ForeseeCut& question);
    /// The words are about to change, or nobody asks any more. Does not wait.
    void forget();
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Ground; ///< words and labels
    struct Work; ///< a question and what comes of it

    /// @return whether all is read
    [[nodiscard]] bool read(VoxelFields& fields, std::uint8_t plane, bool toTheEnd);
    void post();
    void show(VoxelFields& fields);

    VolumeTextures& m_textures;
    std::shared_ptr<Ground> m_ground;
    std::shared_ptr<Work> m_work; ///< asked last
    std::optional<core::ForeseenCut> m_answer; ///< of it; nothing, where the cut is refused
    std::optional<core::Error> m_refused; ///< why
    std::vector<core::ForeseenCut::Brick> m_shown; ///< what the marks say
    BrickField m_marks; ///< R8UI, 1: foreseen to go
    std::optional<core::TaskThread> m_worker; ///< from the first question on
};

} // namespace gpu
