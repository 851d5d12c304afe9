// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/export/common/ExportMask.h"

#include <QObject>

#include <functional>
#include <vector>

namespace ui {

/// Runs one export on another thread. It holds copies of all it needs, so the study may be edited
/// or closed meanwhile. The destructor cancels and waits.
class ExportJob : public QObject {
    Q_OBJECT

public:
    struct Plane {
        std::uint8_t plane = 0;
        std::vector<std::uint8_t> labels; ///< x fastest
    };

    using QObject::QObject;

    /// @param write called on the job's thread; owns all it needs
    void start(std::function<core::Result<core::ExportReport>(const core::Progress&)> write);
    /// Asks it to end early. The outcome is still reported: the file may already be complete.
    void cancel() { m_task.stop(); }
    [[nodiscard]] bool running() const { return m_task.running(); }

Q_SIGNALS:
    void progressed(const QString& step, int done, int total);
    void finished(const core::ExportReport& report);
    void failed(const core::Error& error);

private:
    core::Background::Task m_task;
    core::Background m_background;
};

} // namespace ui
