// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/PacsBrowserDialog.h"

#include "ui/base/ErrorText.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/pacs/CopiesRow.h"
#include "ui/pacs/PacsCache.h"
#include "ui/pacs/SearchForm.h"
#include "ui/pacs/SeriesPreview.h"
#include "ui/pacs/SourcesDialog.h"
#include "ui/settings/PacsSources.h"
#include "ui/widgets/StateLine.h"

#include <QComboBox>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>

namespace ui {

namespace {

const QString lastSourceKey = QStringLiteral("pacs/lastSource");
constexpr int mostStudies = 500;

/// What the source counts of a choice; −1: it does not say.
int countOf(const HitsTree::Choice& choice)
{
    return choice.series ? choice.series->instances : choice.study.instances;
}

int imagesIn(const QString& copy)
{
    return int(QDir(copy).entryList({QStringLiteral("*.dcm")}, QDir::Files).size());
}

} // namespace

PacsBrowserDialog::PacsBrowserDialog(QWidget* parent)
    : QDialog(parent)
    , m_cache(pacsCache())
    , m_source(new QComboBox(this))
    , m_form(new SearchForm(this))
    , m_hits(new HitsTree(this))
    , m_preview(new SeriesPreview(m_cache, this))
    , m_state(new StateLine(QStringLiteral("pacsState"), this))
    , m_progress(new QProgressBar(this))
    , m_copies(new CopiesRow(m_cache, this))
    , m_test(new QPushButton(tr("Test"), this))
    , m_edit(new QPushButton(tr("Sources …"), this))
    , m_search(new QPushButton(tr("Search"), this))
    , m_download(new QPushButton(tr("Download"), this))
    , m_open(new QPushButton(tr("Open"), this))
    , m_close(new QPushButton(tr("Close"), this))
{
    setWindowTitle(tr("From PACS"));
    resize(1140, 640);
    build();

    connect(m_test, &QPushButton::clicked, this, &PacsBrowserDialog::test);
    connect(m_search, &QPushButton::clicked, this, &PacsBrowserDialog::search);
    connect(m_form, &SearchForm::searchRequested, this, &PacsBrowserDialog::search);
    connect(m_form, &SearchForm::changed, this, [this] { m_state->say(m_form->problem()); });
    connect(m_hits, &HitsTree::seriesRequested, this, &PacsBrowserDialog::askForSeries);
    connect(m_hits, &HitsTree::choiceChanged, this, &PacsBrowserDialog::showChoice);
    connect(m_hits, &HitsTree::openRequested, this, [this] { download(true); });
    connect(m_download, &QPushButton::clicked, this, [this] { download(false); });
    connect(m_open, &QPushButton::clicked, this, [this] { download(true); });
    connect(m_close, &QPushButton::clicked, this, &PacsBrowserDialog::reject);
    connect(m_edit, &QPushButton::clicked, this, [this] {
        if (SourcesDialog(this).exec() == QDialog::Accepted)
            fillSources();
    });
    connect(m_copies, &CopiesRow::cleared, this, [this](int removed, bool someStay) {
        const QString count =
            removed == 1 ? tr("1 copy was removed") : tr("%1 copies were removed").arg(removed);
        m_state->say(someStay ? count + tr("; what is open stays.") : count + u'.');
        markCopies();
    });
    connect(&m_downloadJob, &BackgroundJob::progressed, this,
        [this](const QString& step, int done, int total) {
            m_progress->setRange(0, std::max(total, 0));
            m_progress->setValue(done);
            m_state->say(total > 0 ? tr("%1 · %2 of %3 images").arg(step).arg(done).arg(total)
                                   : tr("%1 · %2 images").arg(step).arg(done));
        });
    connect(&m_seriesJob, &BackgroundJob::ended, this, [this] {
        if (!m_awaited.isEmpty())
            m_awaited.removeFirst();
        askForNextSeries();
    });
    for (BackgroundJob* job : {&m_queryJob, &m_downloadJob})
        connect(job, &BackgroundJob::ended, this, &PacsBrowserDialog::showButtons);
    fillSources();
    showCopies();
}

PacsBrowserDialog::~PacsBrowserDialog() = default;

void PacsBrowserDialog::build()
{
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_progress->hide();
    m_search->setObjectName(QStringLiteral("pacsSearch"));
    m_open->setObjectName(QStringLiteral("pacsOpen"));
    m_download->setObjectName(QStringLiteral("pacsDownload"));
    m_close->setObjectName(QStringLiteral("pacsClose"));
    m_search->setDefault(true);
    for (QPushButton* button : {m_test, m_edit, m_download, m_open, m_close})
        button->setAutoDefault(false);

    auto* searching = new QHBoxLayout;
    searching->setSpacing(theme::padding);
    searching->addWidget(m_form, 1);
    searching->addWidget(m_search, 0, Qt::AlignBottom);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(theme::padding);
    middle->addWidget(m_hits, 1);
    middle->addWidget(m_preview);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(theme::smallPadding);
    buttons->addWidget(m_copies);
    buttons->addStretch(1);
    buttons->addWidget(m_close);
    buttons->addWidget(m_download);
    buttons->addWidget(m_open);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    layout->addWidget(sourceRow());
    layout->addLayout(searching);
    layout->addLayout(middle, 1);
    layout->addWidget(m_state);
    layout->addWidget(m_progress);
    layout->addLayout(buttons);
    tabAsLaidOut(*this);
}

QWidget* PacsBrowserDialog::sourceRow()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    m_source->setObjectName(QStringLiteral("pacsSource"));
    m_source->setMinimumWidth(420);
    layout->addWidget(new QLabel(tr("Source"), row));
    layout->addWidget(m_source);
    layout->addWidget(m_test);
    layout->addStretch(1);
    layout->addWidget(m_edit);
    return row;
}

void PacsBrowserDialog::fillSources()
{
    m_sources = pacsSources();
    m_source->clear();
    for (const core::PacsSource& one : m_sources)
        m_source->addItem(QStringLiteral("%1  ·  %2").arg(one.name, one.address()), one.name);
    m_source->setCurrentIndex(
        std::max(0, m_source->findData(QSettings().value(lastSourceKey).toString())));
    m_source->setPlaceholderText(tr("none yet"));
    m_state->say(m_sources.empty()
            ? tr("There is no source yet: add one by Sources … at the right.")
            : QString());
    showButtons();
}

const core::PacsSource* PacsBrowserDialog::source() const
{
    const int row = m_source->currentIndex();
    return row < 0 || row >= int(m_sources.size()) ? nullptr : &m_sources[std::size_t(row)];
}

void PacsBrowserDialog::test()
{
    const core::PacsSource* one = source();
    if (!one || m_downloadJob.running())
        return;
    m_state->say(tr("Asking %1 …").arg(one->address()));
    m_queryJob.start(
        [this, asked = *one](const core::Progress& progress) -> std::function<void()> {
            const core::Result<void> answered = core::echoNode(asked, progress);
            return [this, asked, answered] {
                if (answered)
                    m_state->say(tr("✓ %1 answers.").arg(asked.address()), "good");
                else
                    m_state->say(errorText(answered.error()), "bad");
            };
        },
        [this](const core::Error& error) { m_state->say(errorText(error), "bad"); });
    showButtons();
}

void PacsBrowserDialog::search()
{
    const core::PacsSource* one = source();
    if (!one || m_downloadJob.running() || !m_form->problem().isEmpty())
        return;
    QSettings().setValue(lastSourceKey, one->name);
    m_searched = *one;
    m_awaited.clear();
    m_seriesJob.cancel();
    m_hits->showStudies({});
    showChoice();
    m_state->say(tr("Searching %1 …").arg(one->address()));
    m_queryJob.start(
        [this, asked = *one, filter = m_form->filter()](
            const core::Progress& progress) -> std::function<void()> {
            const auto found = core::findStudies(asked, filter, mostStudies, progress);
            return [this, found] {
                if (!found)
                    return m_state->say(errorText(found.error()), "bad");
                m_hits->showStudies(found->hits);
                showCopies();
                const std::size_t count = found->hits.size();
                if (found->more)
                    m_state->say(tr("The first %1 studies; there are more: say more of what you "
                                    "look for.")
                                     .arg(count),
                        "caution");
                else if (count == 0)
                    m_state->say(tr("No study there matches."));
                else
                    m_state->say(count == 1 ? tr("1 study") : tr("%1 studies").arg(count));
            };
        },
        [this](const core::Error& error) { m_state->say(errorText(error), "bad"); });
    showButtons();
}

void PacsBrowserDialog::askForSeries(const QString& studyUid)
{
    if (m_awaited.contains(studyUid))
        return;
    m_awaited.append(studyUid);
    if (!m_seriesJob.running())
        askForNextSeries();
}

void PacsBrowserDialog::askForNextSeries()
{
    if (m_awaited.isEmpty())
        return;
    m_seriesJob.start(
        [this, studyUid = m_awaited.front(), asked = m_searched](
            const core::Progress& progress) -> std::function<void()> {
            const auto found = core::findSeries(asked, studyUid, progress);
            return [this, studyUid, found] {
                if (found)
                    m_hits->showSeries(studyUid, *found);
                else
                    m_hits->showTrouble(studyUid, errorText(found.error()));
                showCopies();
            };
        },
        [this, studyUid = m_awaited.front()](
            const core::Error& error) { m_hits->showTrouble(studyUid, errorText(error)); });
}

void PacsBrowserDialog::showChoice()
{
    showButtons();
    m_preview->showChoice(m_hits->chosen(), m_searched);
}

QString PacsBrowserDialog::pathOf(const HitsTree::Choice& choice) const
{
    return m_cache.pathOf(
        m_searched.address(), {.studyUid = choice.study.studyUid, .seriesUid = choice.seriesUid()});
}

QString PacsBrowserDialog::copyOf(const HitsTree::Choice& choice) const
{
    const QString path = pathOf(choice);
    return QDir(path).exists() ? path : QString();
}

void PacsBrowserDialog::download(bool thenOpen)
{
    const auto choice = m_hits->chosen();
    if (!choice || m_downloadJob.running())
        return;
    m_preview->stop();
    const QString path = pathOf(*choice);
    const core::RetrieveWish wish{
        .studyUid = choice->study.studyUid, .seriesUid = choice->seriesUid()};
    m_progress->setRange(0, 0);
    m_state->say(tr("Asking %1 what it holds of it …").arg(m_searched.address()));
    m_downloadJob.start(
        [this, asked = m_searched, wish, path, counted = countOf(*choice), thenOpen,
            cache = m_cache,
            limit = cacheLimitBytes()](const core::Progress& progress) -> std::function<void()> {
            core::Result<core::Retrieved> got;
            if (const core::Result<void> ready = cache.prepare(); !ready)
                got = tl::unexpected<core::Error>(ready.error());
            else if (QDir(path).exists())
                cache.touch(path);
            else
                got = core::retrieve(asked, wish, path, progress);
            if (got) {
                cache.touch(path);
                // Not what has just come, however large.
                const core::DownloadCache::Hold hold = cache.hold(path);
                cache.shrinkTo(limit);
            }
            const int present = imagesIn(path);
            return [this, path, got, present, counted, thenOpen] {
                if (!got)
                    return m_state->say(errorText(got.error()), "bad");
                showCopies();
                sayDownloaded(*got, present, counted);
                if (!thenOpen)
                    return;
                Q_EMIT openRequested(path);
                accept();
            };
        },
        [this](const core::Error& error) { m_state->say(errorText(error), "bad"); });
    showButtons();
}

void PacsBrowserDialog::sayDownloaded(const core::Retrieved& got, int present, int counted)
{
    const int count = got.received + got.kept;
    if (count > 0)
        return m_state->say(tr("✓ %1 images are here, each checked.").arg(count), "good");
    if (present >= counted)
        return m_state->say(tr("✓ It is here already."), "good");
    // What sources count is not always what they hold: the copy stays until somebody clears it.
    m_state->say(tr("It is here already, with %1 of the %2 images that the source counts. To fetch "
                    "all of them, clear the local copies first, with the study closed.")
                     .arg(present)
                     .arg(counted),
        "caution");
}

void PacsBrowserDialog::showButtons()
{
    const bool isLoading = m_downloadJob.running();
    const bool isOne = m_hits->chosen().has_value();
    m_progress->setVisible(isLoading);
    m_close->setText(isLoading ? tr("Abort") : tr("Close"));
    m_download->setEnabled(isOne && !isLoading);
    m_open->setEnabled(isOne && !isLoading);
    m_search->setEnabled(source() && !isLoading);
    m_test->setEnabled(source() && !isLoading);
    m_source->setEnabled(!isLoading);
    m_edit->setEnabled(!isLoading);
    m_hits->setEnabled(!isLoading);
    m_copies->setClearable(!isLoading);
}

void PacsBrowserDialog::showCopies()
{
    markCopies();
    m_copies->count();
}

void PacsBrowserDialog::markCopies()
{
    m_hits->markHere([this](const HitsTree::Choice& choice) { return !copyOf(choice).isEmpty(); });
}

void PacsBrowserDialog::reject()
{
    if (!m_downloadJob.running())
        return QDialog::reject();
    m_downloadJob.cancel();
    m_state->say(tr("Aborted. What has come is kept: the same download goes on from there."));
}

} // namespace ui
