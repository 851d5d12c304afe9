// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameSource.h"

#include <QObject>

#include <map>
#include <mutex>

namespace ui {

/// Passes finished frames from the engine's thread to the GUI thread. If several frames of one view
/// arrive before the GUI thread looks, the latest wins; only one queued call is under way at a
/// time.
class FrameInbox : public QObject {
    Q_OBJECT

public:
    /// Becomes the listener of the source until it is destroyed.
    explicit FrameInbox(gpu::FrameSource& source, QObject* parent = nullptr);
    ~FrameInbox() override;

    /// Drops the frames that wait: the views that they are for show something else by now. Call it
    /// when the source has forgotten these views.
    void drop();

Q_SIGNALS:
    /// On the GUI thread.
    void arrived(const gpu::Frame& frame);

private:
    void put(const gpu::Frame& frame); ///< any thread
    void deliver();

    gpu::FrameSource& m_source;
    std::mutex m_mutex;
    std::map<gpu::ViewId, gpu::Frame> m_waiting; ///< guarded by m_mutex
};

} // namespace ui
