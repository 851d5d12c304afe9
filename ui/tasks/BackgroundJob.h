// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"

#include <QObject>

#include <functional>

namespace ui {

/// Runs one piece of work at a time on another thread; the GUI thread never waits for it. Starting
/// a new one cancels the one under way, whose outcome is dropped.
class BackgroundJob : public QObject {
    Q_OBJECT

public:
    /// Called on another thread.
    /// @return a function that is called with the outcome on the GUI thread
    using Work = std::function<std::function<void()>(const core::Progress&)>;

    using Failed = std::function<void(const core::Error&)>;

    explicit BackgroundJob(QObject* parent = nullptr);
    /// Cancels without waiting. All such work is waited for when the program ends.
    ~BackgroundJob() override;

    /// @param failed called on the GUI thread with what @p work has thrown
    void start(Work work, Failed failed);
    void cancel();
    [[nodiscard]] bool running() const { return m_task.running(); }

Q_SIGNALS:
    void progressed(const QString& step, int done, int total);
    /// Emitted after the outcome was delivered, or after cancelling.
    void ended();

private:
    core::Background::Task m_task;
};

} // namespace ui
