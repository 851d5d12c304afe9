// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/ExportJob.h"

#include "ui/texts/ProgressTexts.h"

#include <utility>

namespace ui {

void ExportJob::start(std::function<core::Result<core::ExportReport>(const core::Progress&)> write)
{
    if (running())
        return;
    m_task = m_background.start(
        this, std::move(write),
        [this](const core::Result<core::ExportReport>& outcome) {
            if (outcome)
                Q_EMIT finished(*outcome);
            else
                Q_EMIT failed(outcome.error());
        },
        [this](core::ProgressStep step, int done, int total) {
            Q_EMIT progressed(progressText(step), done, total);
        });
}

} // namespace ui
