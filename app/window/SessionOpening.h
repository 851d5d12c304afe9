// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/steps/SessionPlan.h"
#include "core/base/Result.h"
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

/// A session on its way into the window: made beside the GUI thread, which never waits for GL. One
/// that nobody takes closes its file, and leaves none that was made for it.
struct SessionOpening {
    struct Wish {
        QString file; ///< gone on with as planFor() says; one that is not there is begun
        /// What is sound of it; null: not looked into yet.
        std::shared_ptr<const core::SessionContents> contents;
        bool redo = true; ///< of planFor()
        std::function<void()> wakeUp; ///< of the session
    };

    /// The engine, made anew where its context is lost, takes the volume in, and the file is begun
    /// or gone on with. Blocks for as long; any thread, one call at a time, while no session uses
    /// the engine.
    [[nodiscard]] static std::shared_ptr<SessionOpening> make(
        gpu::GpuEngine& engine, core::LoadedVolume loaded, const Wish& wish);

    SessionOpening() = default;
    SessionOpening(const SessionOpening&) = delete;
    SessionOpening& operator=(const SessionOpening&) = delete;
    ~SessionOpening();

    /// Errors: of planFor(), openPlanned(), core::checkSession(), EditSession::create() and
    /// GpuEngine::renew().
    core::Result<std::unique_ptr<core::EditSession>> session = nullptr;
    QString file; ///< of the session
    std::shared_ptr<const core::SessionContents> contents; ///< of the file there was; null: none
    std::optional<SessionPlan> plan; ///< likewise
    std::optional<core::Error> notFromStudy; ///< of the volume
};

} // namespace app
