// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/growth/GrowthProgress.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {
struct EngineExtension;
struct EngineResult;
} // namespace core

namespace gpu {

/// A kernel at work on the open edit. It writes voxels, each brick captured before it is written,
/// and knows which; what was there before, and what becomes of the changes, is the transaction's
/// (EditTransaction). Engine thread only.
class EditWork {
public:
    EditWork() = default;
    EditWork(const EditWork&) = delete;
    EditWork& operator=(const EditWork&) = delete;
    virtual ~EditWork() = default;

    /// Errors: InvalidField where the extension is of another kind of edit, or not sound.
    virtual core::Result<void> extend(const core::EngineExtension& extension);
    /// Puts @p next behind @p earlier, which are of one kind, where extending by both at once comes
    /// to the same. @return whether it did
    [[nodiscard]] virtual bool join(
        core::EngineExtension& earlier, core::EngineExtension& next) const;

    /// Whether there is more to do that was asked for; done by advance().
    [[nodiscard]] virtual bool hasStepsLeft() const { return false; }
    /// At which pace; 0: as fast as it goes.
    [[nodiscard]] virtual double generationsPerSecond() const { return 0.0; }
    /// Does up to @p rings of a growth, or so much of other work.
    virtual void advance(int rings);

    /// What it may have written so far, each once.
    [[nodiscard]] virtual std::vector<core::BrickKey> touchedKeys() const = 0;
    /// The changes stand, and are in the result: fills in what it alone knows.
    virtual void finish(core::EngineResult& result);
    /// Everything was put back.
    virtual void rollBack(core::EngineResult& result);
    /// Something failed, and it is given up: it puts nothing back, but memory that it shares.
    virtual void abandon() { }
    [[nodiscard]] virtual core::GrowthProgress progress() const { return {}; }
    /// The plane in which it grows; none if it is no GrowBurst.
    [[nodiscard]] virtual std::optional<std::uint8_t> growingPlane() const { return {}; }
};

/// These bricks of one field and plane.
[[nodiscard]] std::vector<core::BrickKey> keysOf(
    core::Field field, std::uint8_t plane, const std::vector<std::uint32_t>& bricks);

} // namespace gpu
