// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/SeriesPreview.h"

#include "core/study/StudyLoader.h"
#include "ui/base/ErrorText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/tasks/ThumbnailLoader.h"

#include <QLabel>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include <functional>

namespace ui {

namespace {

constexpr int pictureSize = 232;

QString wordsOf(const HitsTree::Choice& choice)
{
    QStringList words{personName(choice.study.patientName)};
    if (!choice.study.birthDate.isEmpty())
        words += QObject::tr("born %1").arg(choice.study.birthDate);
    if (!choice.study.accessionNumber.isEmpty())
        words += QObject::tr("accession %1").arg(choice.study.accessionNumber);
    if (choice.series)
        words += QStringLiteral("%1 %2").arg(choice.series->modality, choice.series->description);
    words.removeAll(QString());
    return words.join(u'\n');
}

struct Made {
    QImage picture;
    QString trouble;
};

Made make(const core::PacsSource& source, const core::SeriesHit& series,
    const core::DownloadCache& cache, const core::Progress& progress)
{
    if (const core::Result<void> ready = cache.prepare(); !ready)
        return {{}, errorText(ready.error())};
    const QTemporaryDir folder(
        cache.pathOf(QString(), {}).section(u'/', 0, -2) + QStringLiteral("/.picture-XXXXXX"));
    const core::Result<QString> file =
        core::retrieveMiddle(source, series, folder.filePath(QStringLiteral("middle")), progress);
    if (!file)
        return {{}, errorText(file.error())};
    const auto volume = core::loadVolume(*file);
    if (!volume)
        return {{}, errorText(volume.error())};
    return {thumbnail(*volume, pictureSize), {}};
}

} // namespace

SeriesPreview::SeriesPreview(const core::DownloadCache& cache, QWidget* parent)
    : QWidget(parent)
    , m_cache(cache)
    , m_picture(new QLabel(this))
    , m_words(new QLabel(this))
{
    setFixedWidth(pictureSize);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    m_picture->setObjectName(QStringLiteral("pacsPicture"));
    m_picture->setFixedSize(pictureSize, pictureSize);
    m_picture->setAlignment(Qt::AlignCenter);
    m_picture->setWordWrap(true);
    m_picture->setStyleSheet(QStringLiteral("background: #000; color: %1; border-radius: 4px;")
                                 .arg(theme::secondary.name()));
    m_words->setObjectName(QStringLiteral("pacsWords"));
    m_words->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    m_words->setProperty("role", QStringLiteral("secondary"));
    m_words->setAlignment(Qt::AlignTop);
    layout->addWidget(m_picture);
    layout->addWidget(m_words, 1);
    m_delay.setSingleShot(true);
    m_delay.setInterval(250);
    connect(&m_delay, &QTimer::timeout, this, &SeriesPreview::ask);
    showChoice({}, {});
}

void SeriesPreview::showChoice(
    const std::optional<HitsTree::Choice>& choice, const core::PacsSource& source)
{
    stop();
    m_choice = choice;
    m_source = source;
    m_words->setText(choice ? wordsOf(*choice) : QString());
    if (!choice)
        return sayInstead(tr("A picture of the series that is chosen"));
    if (!choice->series)
        return sayInstead(tr("Choose one of its series for a picture"));
    // One object may be a whole volume, or no picture at all.
    if (choice->series->instances == 1)
        return sayInstead(tr("One object; no picture"));
    sayInstead(QString());
    m_delay.start();
}

void SeriesPreview::stop()
{
    m_job.cancel();
    m_delay.stop();
}

void SeriesPreview::ask()
{
    sayInstead(tr("Asking for a picture …"));
    m_job.start(
        [this, source = m_source, series = *m_choice->series, cache = m_cache](
            const core::Progress& progress) -> std::function<void()> {
            const Made made = make(source, series, cache, progress);
            return [this, made] {
                if (made.picture.isNull())
                    sayInstead(tr("No picture"), made.trouble);
                else
                    showPicture(made.picture);
            };
        },
        [this](const core::Error& error) { sayInstead(tr("No picture"), errorText(error)); });
}

void SeriesPreview::showPicture(const QImage& picture)
{
    m_picture->setToolTip(QString());
    m_picture->setPixmap(QPixmap::fromImage(picture));
}

void SeriesPreview::sayInstead(const QString& sentence, const QString& why)
{
    m_picture->setText(sentence);
    m_picture->setToolTip(why);
}

} // namespace ui
