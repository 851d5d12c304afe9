// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "ui/settings/KeyframeRule.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

namespace gpu {
class FrameSource;
struct Frame;
} // namespace gpu

namespace app {

class SteadySession;

/// Takes the pictures (keyframes) of a session that is made without a window, by the same rule as
/// the window (ui/settings/KeyframeRule): they show the initial 3D view of the study.
class RunKeyframes {
public:
    /// @param session outlives this object and is open; the engine knows the volume's geometry
    explicit RunKeyframes(SteadySession& session);
    ~RunKeyframes();

    /// To be called after every step; waits for the picture if one is due.
    /// @pre the session is settled
    void follow();
    /// To be called before the session is closed; waits likewise.
    void close();

private:
    void take(const gpu::Frame& frame);
    void keep();

    gpu::FrameSource& m_frames;
    SteadySession& m_session;
    ui::KeyframeRule m_rule;
    std::size_t m_rows = 0; ///< number of history rows, as last seen
    std::mutex m_mutex;
    std::condition_variable m_arrived;
    /// Guarded by m_mutex; none if the picture was refused.
    std::shared_ptr<const std::vector<std::uint8_t>> m_picture;
    bool m_answered = false; ///< guarded by m_mutex
};

} // namespace app
