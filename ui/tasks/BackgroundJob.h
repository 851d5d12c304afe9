// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"

#include <QObject>

#include <functional>

namespace ui {

/// One piece of work at a time beside the GUI thread, which never waits for it. What is begun anew
/// calls off what was under way, whose outcome nobody hears of.
class BackgroundJob : public QObject {
    Q_OBJECT

public:
    /// Called on a thread of its own. @return what is done with the outcome, on the GUI thread
    using Work = std::function<std::function<void()>(const core::Progress&)>;

    using Failed = std::function<void(const core::Error&)>;

    explicit BackgroundJob(QObject* parent = nullptr);
    /// Calls off; waits for nothing. The program's end does, for all of them.
    ~BackgroundJob() override;

    /// @param failed told what @p work has thrown, on the GUI thread
    void start(Work work, Failed failed);
    void cancel();
    [[nodiscard]] bool running() const { return m_task.running(); }

Q_SIGNALS:
    void progressed(const QString& step, int done, int total);
    /// Behind the outcome, or called off.
    void ended();

private:
    core::Background::Task m_task;
};

} // namespace ui
