// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/StudyOpener.h"

#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/SessionStudy.h"
#include "ui/texts/ProgressTexts.h"

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
    constexpr int soon = 200; // ms
    m_later.setSingleShot(true);
    m_later.setInterval(soon);
    connect(&m_later, &QTimer::timeout, this, [this] {
        if (const auto held = std::exchange(m_held, std::nullopt))
            take(*held);
    });
}

void StudyOpener::abandon()
{
    blockSignals(true);
    cancel();
    m_background.finish();
}

void StudyOpener::open(const QString& path, const QString& series)
{
    if (core::SessionFile::isNamedAt(path))
        return openSession(path);
    start(path, [this, path, series](const auto& progress, const auto& early) -> Completion {
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
    start(path, [this, study, series, path](const auto& progress, const auto& early) -> Completion {
        Volume volume = load(*study, series, progress, early);
        if (!volume)
            return [this, error = volume.error()] { Q_EMIT failed(error); };
        return [this, path, volume = *volume] { Q_EMIT loaded(volume, path); };
    });
}

void StudyOpener::openSession(const QString& sessionFile, const QString& place)
{
    start(sessionFile,
        [this, sessionFile, place](const core::Progress& progress, const auto&) -> Completion {
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
    start(path, [this, path, job](const auto& progress, const auto& early) -> Completion {
        auto volume = job(progress, early);
        if (!volume)
            return [this, error = volume.error()] { Q_EMIT failed(error); };
        auto shared = std::make_shared<core::LoadedVolume>(std::move(*volume));
        return [this, path, shared] { Q_EMIT loaded(shared, path); };
    });
}

void StudyOpener::start(const QString& path,
    std::function<Completion(const core::Progress&, const core::EarlySliceListener&)> work)
{
    cancel();
    // What was called off may take a while to notice; nobody but the next task waits for it.
    m_task = m_background.start(
        this,
        [this, work = std::move(work)](
            const core::Progress& progress, const core::Background::Meanwhile& meanwhile) {
            return work(
                progress, [this, &meanwhile](const std::shared_ptr<const core::EarlySlice>& slice) {
                    meanwhile([this, slice] { Q_EMIT sliceReady(slice); });
                });
        },
        [this](const core::Result<Completion>& outcome) { take(outcome); },
        [this](core::ProgressStep step, int done, int total) {
            Q_EMIT progressed(progressText(step), done, total);
        });
    Q_EMIT started(path);
}

void StudyOpener::goOn(const QString& step, std::function<Completion()> work)
{
    m_task = m_background.start(
        this, std::move(work), [this](const core::Result<Completion>& outcome) { take(outcome); });
    Q_EMIT progressed(step, 0, 0);
}

void StudyOpener::take(const core::Result<Completion>& outcome)
{
    if (m_holdsWhile && m_holdsWhile()) {
        m_held = outcome;
        m_later.start();
        return;
    }
    if (outcome)
        (*outcome)();
    else
        Q_EMIT failed(outcome.error());
    if (!busy())
        Q_EMIT finished();
}

void StudyOpener::cancel()
{
    if (!busy())
        return;
    m_task.cancel();
    m_later.stop();
    m_held.reset();
    Q_EMIT finished();
}

} // namespace ui
