// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/SessionPlan.h"
#include "core/base/Result.h"
#include "core/base/files/FollowedFile.h"
#include "core/session/EditSession.h"

#include <QString>

#include <functional>
#include <memory>
#include <optional>

namespace core {
struct LoadedVolume;
struct SessionContents;
} // namespace core
namespace gpu {
class GpuEngine;
}

namespace app {

/// A session that is being opened for the window on another thread, because the GUI thread never
/// waits for GL. If nobody takes the session its file is closed, and a file that was made for it is
/// removed.
struct SessionOpening {
    struct Wish {
        QString file; ///< continued as planFor() plans it; if it does not exist it is made
        /// Its sound part; null if it was not checked yet.
        std::shared_ptr<const core::SessionContents> contents;
        bool redo = true; ///< of planFor()
        std::function<void()> wakeUp; ///< of the session
    };

    /// Opens the volume on the engine, which is made again if its context is lost, and begins or
    /// continues the file. Blocks until that is done; any thread, one call at a time, while no
    /// session uses the engine.
    [[nodiscard]] static std::shared_ptr<SessionOpening> make(
        gpu::GpuEngine& engine, core::LoadedVolume loaded, const Wish& wish);

    SessionOpening() = default;
    SessionOpening(const SessionOpening&) = delete;
    SessionOpening& operator=(const SessionOpening&) = delete;
    ~SessionOpening();

    /// The session. Errors: those of planFor(), openPlanned(), core::checkSession(),
    /// EditSession::create() and GpuEngine::renew().
    core::Result<std::unique_ptr<core::EditSession>> session = nullptr;
    QString file; ///< of the session
    core::FollowedFile opened; ///< that file
    /// Contents of the existing file; null if there was none.
    std::shared_ptr<const core::SessionContents> contents;
    std::optional<SessionPlan> plan; ///< the plan for the existing file; none if there was none
    std::optional<core::Error> notFromStudy; ///< of the volume
};

} // namespace app
