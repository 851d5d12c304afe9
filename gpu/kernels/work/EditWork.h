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

/// The kernel work on the open edit. It writes voxels, after capturing each brick that it writes,
/// and knows which it has written. The transaction (EditTransaction) keeps what was there before
/// and decides what becomes of the changes. Engine thread only.
class EditWork {
public:
    EditWork() = default;
    EditWork(const EditWork&) = delete;
    EditWork& operator=(const EditWork&) = delete;
    virtual ~EditWork() = default;

    /// Continues the edit with an extension. Errors: InvalidField if the extension belongs to
    /// another kind of edit or is invalid.
    virtual core::Result<void> extend(const core::EngineExtension& extension);
    /// Joins two extensions of one kind: appends @p next to @p earlier, if extending by both at
    /// once gives the same result.
    /// @return whether it did
    [[nodiscard]] virtual bool join(
        core::EngineExtension& earlier, core::EngineExtension& next) const;

    /// Whether requested steps are left; advance() does them.
    [[nodiscard]] virtual bool hasStepsLeft() const { return false; }
    /// The pace of these steps; 0: as fast as possible.
    [[nodiscard]] virtual double generationsPerSecond() const { return 0.0; }
    /// Does up to @p rings generations of a growth, or a similar amount of other work.
    virtual void advance(int rings);

    /// The keys of all bricks that it may have written so far, each once.
    [[nodiscard]] virtual std::vector<core::BrickKey> touchedKeys() const = 0;
    /// Called after the commit, with the changes already in @p result. Adds what only this work
    /// knows.
    virtual void finish(core::EngineResult& result);
    /// Called after a rollback, when all voxels are restored.
    virtual void rollBack(core::EngineResult& result);
    /// Called when the edit has failed and is given up. Restores no voxels, and only releases
    /// memory that it shares with other edits.
    virtual void abandon() { }
    [[nodiscard]] virtual core::GrowthProgress progress() const { return {}; }
    /// The label plane in which it grows; none if it is no GrowBurst.
    [[nodiscard]] virtual std::optional<std::uint8_t> growingPlane() const { return {}; }
};

/// Returns the keys of some bricks of one field and plane.
[[nodiscard]] std::vector<core::BrickKey> keysOf(
    core::Field field, std::uint8_t plane, const std::vector<std::uint32_t>& bricks);

} // namespace gpu
