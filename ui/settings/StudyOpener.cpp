// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/StudyOpener.h"

#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"

#include <utility>

namespace ui {

namespace {

using Volume = core::Result<std::shared_ptr<core::LoadedVolume>>;

/// What the worker found: a volume, a study to choose from, or why neither.
struct Found {
    Volume volume;
    std::shared_ptr<const core::Study> choice;
    QString withoutSpacing{}; ///< of the choice: the one that lacks nothing else
};

Volume load(const core::Study& study, const QString& series, const core::Progress& progress,
    const core::EarlySliceListener& early)
{
    auto volume = study.load(series, progress, early);
    if (!volume)
        return tl::unexpected(volume.error());
    return std::make_shared<core::LoadedVolume>(std::move(*volume));
}

Found find(const QString& path, const QString& series, const core::Progress& progress,
    const core::EarlySliceListener& early)
{
    auto study = core::Study::scan(path, progress);
    if (!study)
        return {tl::unexpected(study.error()), nullptr};
    const auto candidates = study->listing().candidates();
    const bool choice =
        candidates.size() > 1 || (candidates.size() == 1 && !candidates.front()->times.isEmpty());
    if (series.isEmpty() && choice)
        return {nullptr, std::make_shared<const core::Study>(std::move(*study))};
    if (const core::SeriesEntry* entry = study->listing().lacksSpacing(series))
        return {nullptr, std::make_shared<const core::Study>(std::move(*study)), entry->key};
    return {load(*study, series, progress, early), nullptr};
}

bool isAboutThePlace(const core::Error& error)
{
    return error.code == core::ErrorCode::StudyMissing
        || error.code == core::ErrorCode::SessionMismatch;
}

} // namespace

StudyOpener::StudyOpener(QObject* parent)
    : QObject(parent)
{
}

StudyOpener::~StudyOpener()
{
    abandon(); // who listens may be coming apart, too
}

void StudyOpener::abandon()
{
    blockSignals(true);
    cancel();
    m_worker.finish();
}

void StudyOpener::open(const QString& path, const QString& series)
{
    if (core::SessionFile::isNamedAt(path))
        return openSession(path);
    start(path, [this, path, series](const auto& progress, const auto& early) -> Tell {
        Found found = find(path, series, progress, early);
        return [this, path, found = std::move(found)] {
            if (!found.withoutSpacing.isEmpty())
                Q_EMIT spacingNeeded(found.choice, found.withoutSpacing);
            else if (found.choice)
                Q_EMIT choiceNeeded(found.choice);
            else if (found.volume)
                Q_EMIT loaded(*found.volume, path);
            else
                Q_EMIT failed(found.volume.error());
        };
    });
}

void StudyOpener::open(const std::shared_ptr<const core::Study>& study, const QString& series)
{
    if (const core::SeriesEntry* entry = study->listing().lacksSpacing(series)) {
        Q_EMIT spacingNeeded(study, entry->key);
        return;
    }
    const QString path = study->listing().path;
    start(path, [this, study, series, path](const auto& progress, const auto& early) -> Tell {
        Volume volume = load(*study, series, progress, early);
        if (!volume)
            return [this, error = volume.error()] { Q_EMIT failed(error); };
        return [this, path, volume = *volume] { Q_EMIT loaded(volume, path); };
    });
}

void StudyOpener::openSession(const QString& sessionFile, const QString& place)
{
    start(sessionFile,
        [this, sessionFile, place](const core::Progress& progress, const auto&) -> Tell {
            // All of it now: once it is open for writing its file cannot be left untouched.
            const auto contents = core::checkSession(sessionFile, progress);
            if (!contents)
                return [this, error = contents.error()] { Q_EMIT failed(error); };
            const core::SessionSource& source = contents->source;
            auto volume = core::loadSessionStudy(sessionFile, source, place, QString(), progress);
            if (!volume && (!place.isEmpty() || isAboutThePlace(volume.error())))
                return [this, sessionFile, format = source.format, error = volume.error()] {
                    Q_EMIT sessionStudyNeeded(sessionFile, format, error);
                };
            if (!volume)
                return [this, error = volume.error()] { Q_EMIT failed(error); };
            auto shared = std::make_shared<core::LoadedVolume>(std::move(*volume));
            auto sound = std::make_shared<const core::SessionContents>(*contents);
            return [this, sessionFile, shared, sound] {
                Q_EMIT sessionLoaded(shared, sessionFile, sound);
            };
        });
}

void StudyOpener::run(const QString& path, Job job)
{
    start(path, [this, path, job](const auto& progress, const auto& early) -> Tell {
        auto volume = job(progress, early);
        if (!volume)
            return [this, error = volume.error()] { Q_EMIT failed(error); };
        auto shared = std::make_shared<core::LoadedVolume>(std::move(*volume));
        return [this, path, shared] { Q_EMIT loaded(shared, path); };
    });
}

void StudyOpener::start(const QString& path,
    std::function<Tell(const core::Progress&, const core::EarlySliceListener&)> work)
{
    cancel();
    // Reports of a job that was cancelled meanwhile are dropped on this side of the queue.
    auto listener = std::make_shared<core::Progress*>(nullptr);
    auto progress = std::make_shared<core::Progress>(
        [this, listener](const QString& step, int done, int total) {
            const core::Progress* mine = *listener;
            QMetaObject::invokeMethod(this, [this, mine, step, done, total] {
                if (m_progress.get() == mine)
                    Q_EMIT progressed(step, done, total);
            });
        });
    *listener = progress.get();
    const core::EarlySliceListener early =
        [this, listener](const std::shared_ptr<const core::EarlySlice>& slice) {
            const core::Progress* mine = *listener;
            QMetaObject::invokeMethod(this, [this, mine, slice] {
                if (m_progress.get() == mine)
                    Q_EMIT sliceReady(slice);
            });
        };
    m_progress = progress;
    m_busy = true;
    Q_EMIT started(path);
    launch([progress, early, work = std::move(work)] { return work(*progress, early); });
}

void StudyOpener::goOn(const QString& step, std::function<Tell()> work)
{
    m_progress = std::make_shared<core::Progress>();
    m_busy = true;
    launch(std::move(work));
    Q_EMIT progressed(step, 0, 0);
}

void StudyOpener::launch(std::function<Tell()> work)
{
    const auto outcome = std::make_shared<Outcome>();
    m_outcome = outcome;
    // What was called off may take a while to notice; nobody but the next worker waits for it.
    m_worker.post(
        [this, outcome, work = std::move(work)]() mutable {
            Tell tell = work();
            work = {};
            setOutcome(outcome, std::move(tell));
        },
        [this, outcome](const core::Error& error) {
            setOutcome(outcome, [this, error] { Q_EMIT failed(error); });
        });
}

void StudyOpener::setOutcome(const std::shared_ptr<Outcome>& outcome, Tell tell)
{
    {
        const std::lock_guard lock(outcome->mutex);
        // What it holds then goes here, before another work begins.
        if (outcome->calledOff)
            return;
        outcome->tell = std::move(tell);
    }
    QMetaObject::invokeMethod(this, [this, outcome] {
        if (m_outcome == outcome)
            take();
    });
}

void StudyOpener::take()
{
    const Tell tell = std::exchange(m_outcome->tell, {});
    m_outcome.reset();
    m_progress.reset();
    m_busy = false;
    tell();
    if (!m_busy)
        Q_EMIT finished();
}

void StudyOpener::cancel()
{
    if (!m_progress)
        return;
    m_progress->cancel();
    m_progress.reset();
    m_busy = false;
    Tell dropped;
    {
        const std::lock_guard lock(m_outcome->mutex);
        m_outcome->calledOff = true;
        dropped = std::exchange(m_outcome->tell, {});
    }
    m_outcome.reset();
    dropped = {}; // before anybody begins something else
    Q_EMIT finished();
}

} // namespace ui
