// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/SessionOffers.h"

#include "core/sessionfile/database/SessionUse.h"
#include "ui/base/Theme.h"

#include <QDir>
#include <QFileInfo>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

using Condition = core::SessionPreview::Condition;

std::vector<core::SessionPreview> readFolder(const QString& folder, const core::Progress& progress)
{
    std::vector<core::SessionPreview> offers;
    const QDir sessions(folder);
    for (const QString& name : sessions.entryList({QStringLiteral("*.burin")}, QDir::Files)) {
        if (progress.cancelled())
            break;
        core::Result<core::SessionPreview> preview = core::previewSession(sessions.filePath(name));
        if (preview && preview->condition != Condition::InUse && preview->steps > 0)
            offers.push_back(*std::move(preview));
    }
    std::sort(offers.begin(), offers.end(), [](const auto& left, const auto& right) {
        return std::pair(right.lastChange, left.file) < std::pair(left.lastChange, right.file);
    });
    return offers;
}

QString stepsText(std::int64_t steps)
{
    return steps == 1 ? SessionOffers::tr("1 step") : SessionOffers::tr("%1 steps").arg(steps);
}

constexpr QSize thumbnailSize{64, 48};

QPixmap thumbnail(const QByteArray& png, double pixelRatio)
{
    const QImage whole = QImage::fromData(png, "PNG");
    if (whole.isNull())
        return {};
    QPixmap small = QPixmap::fromImage(
        whole.scaled(thumbnailSize * pixelRatio, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    small.setDevicePixelRatio(pixelRatio);
    return small;
}

/// One line that is cut where there is no room for it.
class Line : public QLabel {
public:
    Line(const QString& words, const QFont& font, const QColor& colour, QWidget* parent)
        : QLabel(parent)
        , m_words(words)
    {
        setFont(font);
        setTextFormat(Qt::PlainText);
        setStyleSheet(QStringLiteral("color: %1").arg(colour.name()));
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        setText(words);
    }

protected:
    void resizeEvent(QResizeEvent* event) override
    {
        QLabel::resizeEvent(event);
        const QString shown = fontMetrics().elidedText(m_words, Qt::ElideRight, width());
        setText(shown);
        setToolTip(shown == m_words ? QString() : m_words);
    }

private:
    QString m_words;
};

} // namespace

SessionOffers::SessionOffers(QWidget* parent)
    : QWidget(parent)
    , m_cards(new QVBoxLayout(this))
{
    m_cards->setContentsMargins(0, 0, 0, 0);
    m_cards->setSpacing(theme::smallPadding);
    hide();
}

QString SessionOffers::stateText(const core::SessionPreview& preview, const QDateTime& now)
{
    const QString steps = stepsText(preview.steps);
    const QString time = preview.lastChange.toString(QStringLiteral("HH:mm"));
    const QString when = preview.lastChange.date() == now.date()
        ? tr("last at %1").arg(time)
        : tr("last on %1 at %2").arg(preview.lastChange.date().toString(Qt::ISODate), time);
    return preview.condition == Condition::Unfinished ? tr("recovered: %1, %2").arg(steps, when)
                                                      : tr("continue: %1, %2").arg(steps, when);
}

QString SessionOffers::studyText(const core::SessionPreview& preview)
{
    const core::SessionSource& source = preview.source;
    QStringList parts{source.seriesDescription, source.modality, source.studyDate};
    if (source.seriesDescription.isEmpty())
        parts.front() = QFileInfo(source.path).fileName();
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

void SessionOffers::showFolder(const QString& folder)
{
    m_folder = folder;
    using Offers = std::vector<core::SessionPreview>;
    m_reader.replace(
        this,
        [folder](const core::Progress& progress) {
            return folder.isEmpty() ? Offers() : readFolder(folder, progress);
        },
        [this](core::Result<Offers>&& offers) {
            // Where they cannot be read none are offered; they can be opened by name.
            if (offers)
                showOffers(*std::move(offers));
        });
}

void SessionOffers::showOffers(std::vector<core::SessionPreview> offers)
{
    m_offers = std::move(offers);
    m_showAll = false;
    build();
    setVisible(!m_offers.empty());
    Q_EMIT changed();
}

void SessionOffers::build()
{
    while (QLayoutItem* item = m_cards->takeAt(0)) {
        // What asked for this may be among them.
        if (QWidget* old = item->widget()) {
            old->hide();
            old->deleteLater();
        }
        delete item;
    }
    m_cards->addWidget(
        new Line(tr("Sessions to go on with"), theme::headingFont(), theme::secondary, this));
    const int shown = m_showAll ? count() : std::min(count(), shownAtFirst);
    for (int i = 0; i < shown; ++i)
        m_cards->addWidget(card(m_offers[std::size_t(i)]));
    if (shown < count()) {
        auto* more = new QToolButton(this);
        more->setText(tr("Show %1 more").arg(count() - shown));
        more->setCursor(Qt::PointingHandCursor);
        connect(more, &QToolButton::clicked, this, [this] {
            m_showAll = true;
            build();
            Q_EMIT changed();
        });
        m_cards->addWidget(more);
    }
    m_cards->addStretch(1);
}

QWidget* SessionOffers::card(const core::SessionPreview& preview)
{
    const bool recovered = preview.condition == Condition::Unfinished;
    auto* frame = new QFrame(this);
    frame->setObjectName(QStringLiteral("sessionOffer"));
    frame->setStyleSheet(
        QStringLiteral("#sessionOffer { background: %1; border-left: 3px solid %2; "
                       "border-radius: %3px; }")
            .arg(theme::raised.name(), (recovered ? theme::caution : theme::line).name())
            .arg(theme::cornerRadius));
    auto* row = new QHBoxLayout(frame);
    row->setContentsMargins(theme::padding, 8, 8, 8);
    row->setSpacing(theme::smallPadding);
    if (const QPixmap picture = thumbnail(preview.thumbnail, devicePixelRatioF());
        !picture.isNull()) {
        auto* label = new QLabel(frame);
        label->setObjectName(QStringLiteral("sessionThumbnail"));
        label->setPixmap(picture);
        label->setFixedSize(thumbnailSize);
        label->setAlignment(Qt::AlignCenter);
        label->setStyleSheet(QStringLiteral("background: %1").arg(theme::picture.name()));
        row->addWidget(label);
        row->addSpacing(theme::smallPadding);
    }
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(new Line(studyText(preview), theme::bodyFont(), theme::text, frame));
    words->addWidget(new Line(stateText(preview, QDateTime::currentDateTime()), theme::smallFont(),
        recovered ? theme::caution : theme::secondary, frame));
    row->addLayout(words, 1);
    auto* open = new QPushButton(tr("Open"), frame);
    auto* discard = new QPushButton(tr("Discard …"), frame);
    open->setAccessibleName(tr("Open the session of %1").arg(studyText(preview)));
    discard->setAccessibleName(tr("Discard the session of %1").arg(studyText(preview)));
    row->addWidget(open);
    row->addWidget(discard);
    connect(open, &QPushButton::clicked, this,
        [this, file = preview.file] { Q_EMIT openRequested(file); });
    connect(
        discard, &QPushButton::clicked, this, [this, preview] { SessionOffers::discard(preview); });
    return frame;
}

void SessionOffers::discard(const core::SessionPreview& preview)
{
    QMessageBox box(QMessageBox::Question, tr("Discard a session"),
        tr("Discard the session of %1?").arg(studyText(preview)), QMessageBox::NoButton, this);
    box.setInformativeText(tr("Its %1 cannot be brought back. The study stays as it is.")
                               .arg(stepsText(preview.steps)));
    const QPushButton* lose = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
    QPushButton* keep = box.addButton(tr("Keep"), QMessageBox::RejectRole);
    box.setDefaultButton(keep);
    box.exec();
    if (box.clickedButton() != lose)
        return;
    // Another window may have gone on with it since it was listed: what it holds now was not asked
    // about.
    if (!core::isSessionInUse(preview.file)
        && core::sessionChangedAt(preview.file) == preview.lastChange)
        core::removeSession(preview.file);
    showFolder(m_folder);
}

} // namespace ui
