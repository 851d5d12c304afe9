// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/TaskThread.h"
#include "core/export/common/ExportMask.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace ui {

/// One export on a thread of its own: it holds copies of all it needs, so the study may be edited
/// or closed meanwhile. Destroying it cancels and waits.
class ExportJob : public QObject {
    Q_OBJECT

public:
    struct Plane {
        std::uint8_t plane = 0;
        std::vector<std::uint8_t> labels; ///< x fastest
    };

    explicit ExportJob(QObject* parent = nullptr);
    ~ExportJob() override;

    /// @param write called on the job's thread; owns all it needs
    void start(std::function<core::Result<core::ExportReport>(const core::Progress&)> write);
    void cancel();
    [[nodiscard]] bool running() const;

Q_SIGNALS:
    void progressed(const QString& step, int done, int total);
    void finished(const core::ExportReport& report);
    void failed(const core::Error& error);

private:
    void take(const core::Result<core::ExportReport>& outcome);

    struct Work;
    std::shared_ptr<Work> m_work;
    std::optional<core::TaskThread> m_thread; ///< while it runs
};

} // namespace ui
