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

/// Pictures of a session that is made without a window, by the window's rule
/// (ui/settings/KeyframeRule): the 3D view as it opens on a study.
class RunKeyframes {
public:
    /// It is lent, and open. The engine knows the volume's geometry.
    explicit RunKeyframes(SteadySession& session);
    ~RunKeyframes();

    /// After every step; waits for the picture if one is due. @pre the session is settled
    void follow();
    /// Before the session is closed; likewise.
    void close();

private:
    void take(const gpu::Frame& frame);
    void keep();

    gpu::FrameSource& m_frames;
    SteadySession& m_session;
    ui::KeyframeRule m_rule;
    std::size_t m_rows = 0; ///< of the history, as last seen
    std::mutex m_mutex;
    std::condition_variable m_arrived;
    std::shared_ptr<const std::vector<std::uint8_t>> m_picture; ///< under m_mutex; none: refused
    bool m_answered = false; ///< under m_mutex
};

} // namespace app
