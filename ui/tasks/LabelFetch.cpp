// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/LabelFetch.h"

#include "core/session/questions/VoxelQuestions.h"

#include <QPointer>

#include <utility>

namespace ui {

namespace {

core::Error editedMeanwhile()
{
    return {core::ErrorCode::Internal,
        {QStringLiteral("export"), core::Clause::saying("the study was edited meanwhile")}};
}

} // namespace

void LabelFetch::start(
    core::EditSession& session, const std::set<std::uint8_t>& planes, core::Field field)
{
    m_assembling.cancel();
    session.closeOpen();
    const glm::ivec3 size = session.document().volumes.front().geometry.size;
    m_work = std::make_shared<Work>(
        Work{.session = session, .reading = session.questions().beginReading(), .readers = {}});
    for (const std::uint8_t plane : planes)
        m_work->readers.push_back(std::make_shared<core::LabelReader>(size, plane, field));
    askNext();
}

void LabelFetch::askNext()
{
    Work& work = *m_work;
    while (work.current < work.readers.size()) {
        // An answer to what was cancelled, or asked by somebody who is gone, is dropped.
        if (work.session.questions().readOn(work.readers[work.current],
                [fetch = QPointer<LabelFetch>(this), asked = std::weak_ptr<Work>(m_work)](
                    const core::Result<void>& portion) {
                    if (fetch && fetch->m_work && fetch->m_work == asked.lock())
                        fetch->take(portion);
                }))
            return;
        ++work.current;
    }
    work.reading.reset();
    // Putting bricks together is work of its own.
    m_assembling.replace(
        this,
        [readers = std::move(work.readers)] {
            auto planes = std::make_shared<std::vector<ExportJob::Plane>>();
            for (const auto& reader : readers)
                planes->push_back({reader->plane(), reader->takeLabels()});
            return planes;
        },
        [this](const core::Result<std::shared_ptr<std::vector<ExportJob::Plane>>>& planes) {
            if (!planes)
                return fail(planes.error());
            const Work& done = *m_work;
            if (done.position && done.session.history().position() != *done.position)
                return fail(editedMeanwhile());
            m_work.reset();
            m_failures = 0;
            Q_EMIT finished(*planes);
        });
}

void LabelFetch::take(const core::Result<void>& portion)
{
    Work& work = *m_work;
    const core::RowId position = work.session.history().position();
    if (!work.position)
        work.position = position;
    // What stands open has begun since: it is no step yet.
    if (*work.position != position || work.session.transactionOpen())
        return fail(editedMeanwhile());
    if (!portion)
        return fail(portion.error());
    int done = 0;
    int total = 0;
    for (const auto& reader : work.readers) {
        done += reader->bricksRead();
        total += reader->bricks();
    }
    const std::weak_ptr<Work> mine = m_work;
    Q_EMIT progressed(done, total);
    if (m_work && m_work == mine.lock())
        askNext();
}

bool LabelFetch::mayTryAgain(const core::Error& error) const
{
    return error.code == core::ErrorCode::Internal && m_failures < mostFailures;
}

void LabelFetch::fail(const core::Error& error)
{
    const core::RowId position = m_work->session.history().position();
    m_failures = position == m_failedAt ? m_failures + 1 : 1;
    m_failedAt = position;
    m_work.reset();
    Q_EMIT failed(error);
}

} // namespace ui
