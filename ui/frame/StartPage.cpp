// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/StartPage.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/frame/SessionOffers.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int columnWidth = 620;
constexpr int columnGap = 40;
constexpr int leastColumn = 500; ///< of two beside each other

QLabel* text(const QString& words, double pixels, const QColor& colour, QWidget* parent)
{
    auto* label = new QLabel(words, parent);
    QFont font = theme::bodyFont();
    font.setPointSizeF(pixels * 0.75);
    label->setFont(font);
    label->setStyleSheet(QStringLiteral("color: %1").arg(colour.name()));
    label->setWordWrap(true);
    return label;
}

/// A wide button: icon, name, and what it does.
QPushButton* choice(
    const QString& icon, const QString& name, const QString& explanation, QWidget* parent)
{
    auto* button = new QPushButton(parent);
    // By itself it is as high as its text, of which it has none, and no higher.
    button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Minimum);
    button->setObjectName(QStringLiteral("choice"));
    // The style sheet's own height for buttons would win over setMinimumHeight().
    button->setStyleSheet(QStringLiteral("#choice { min-height: 60px; padding: 0; }"));
    button->setCursor(Qt::PointingHandCursor);
    auto* row = new QHBoxLayout(button);
    row->setContentsMargins(18, 10, 18, 10);
    row->setSpacing(16);
    auto* picture = new QLabel(button);
    picture->setPixmap(tintedIcon(icon, theme::accent, 26, parent->devicePixelRatioF()));
    row->addWidget(picture);
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(text(name, 14.0, theme::text, button));
    words->addWidget(text(explanation, 12.0, theme::secondary, button));
    row->addLayout(words, 1);
    // The labels are not to take the clicks.
    for (QLabel* label : button->findChildren<QLabel*>())
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
    button->setAccessibleName(name);
    return button;
}

} // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent)
    , m_columns(new QBoxLayout(QBoxLayout::LeftToRight))
    , m_choices(new QWidget(this))
    , m_recent(new QVBoxLayout)
    , m_sessions(new SessionOffers(this))
{
    QWidget* column = m_choices;
    column->setMaximumWidth(columnWidth);
    m_sessions->setMaximumWidth(columnWidth);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);

    auto* title = new QHBoxLayout;
    title->setSpacing(16);
    auto* mark = new QLabel(column);
    mark->setPixmap(tintedIcon(QStringLiteral("burin"), theme::text, 56, devicePixelRatioF()));
    title->addWidget(mark);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(text(QStringLiteral("Burin"), 30.0, theme::text, column));
    words->addWidget(text(tr("Carve a study open, grow what you mark, sign the mask."), 14.0,
        theme::secondary, column));
    title->addLayout(words, 1);
    layout->addLayout(title);
    layout->addSpacing(18);

    auto* folder = choice(QStringLiteral("open"), tr("Open a study"),
        tr("A folder with DICOM images, or PNG or TIFF slices; everything below it is "
           "searched"),
        column);
    auto* file = choice(QStringLiteral("segments"), tr("Open a file"),
        tr("A volume in one file (NIfTI, NRRD, MetaImage, TIFF), a session (.burin) or one DICOM "
           "file"),
        column);
    auto* demonstration = choice(QStringLiteral("demo"), tr("Open the demonstration"),
        tr("A head made by computation, to try every tool on"), column);
    for (QPushButton* button : {folder, file, demonstration})
        layout->addWidget(button);
    layout->addSpacing(14);
    m_recent->setSpacing(2);
    layout->addLayout(m_recent);
    layout->addSpacing(18);
    layout->addWidget(text(tr("Studies and sessions can also be dropped onto this window.\n"
                              "Research use; not a medical device."),
        12.0, theme::secondary, column));

    auto* centre = new QVBoxLayout(this);
    centre->setContentsMargins(24, 24, 24, 24);
    centre->addStretch(2);
    m_columns->addStretch(1);
    m_columns->addWidget(column, 8);
    m_columns->addSpacing(0);
    m_columns->addWidget(m_sessions, 8);
    m_columns->addStretch(1);
    centre->addLayout(m_columns);
    centre->addStretch(3);

    connect(folder, &QPushButton::clicked, this, &StartPage::openFolderRequested);
    connect(file, &QPushButton::clicked, this, &StartPage::openFileRequested);
    connect(demonstration, &QPushButton::clicked, this, &StartPage::demonstrationRequested);
    connect(m_sessions, &SessionOffers::openRequested, this, &StartPage::sessionRequested);
    connect(m_sessions, &SessionOffers::changed, this, &StartPage::arrange);
}

void StartPage::showSessions(const QString& folder)
{
    m_sessions->showFolder(folder);
}

/// Sessions stand beside the choices where there is room for both.
void StartPage::arrange()
{
    const bool offers = m_sessions->count() > 0;
    const bool beside = !offers || width() >= 2 * leastColumn + columnGap + 48;
    // Below each other they take the width there is.
    for (QWidget* column : {m_choices, static_cast<QWidget*>(m_sessions)})
        column->setMaximumWidth(beside ? columnWidth : QWIDGETSIZE_MAX);
    m_columns->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_columns->itemAt(2)->spacerItem()->changeSize(
        offers && beside ? columnGap : 0, offers && !beside ? 24 : 0);
    m_columns->invalidate();
}

void StartPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void StartPage::showRecent(const QStringList& paths)
{
    while (QLayoutItem* item = m_recent->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    if (paths.isEmpty())
        return;
    m_recent->addWidget(text(tr("Recent"), 12.5, theme::secondary, this));
    for (const QString& path : paths.mid(0, 5)) {
        auto* button = new QToolButton(this);
        const QFileInfo info(path);
        const QString place = info.path();
        button->setText(fontMetrics().elidedText(
            info.fileName() + QStringLiteral("   ") + place, Qt::ElideMiddle, columnWidth - 40));
        button->setToolTip(path);
        button->setCursor(Qt::PointingHandCursor);
        connect(
            button, &QToolButton::clicked, this, [this, path] { Q_EMIT recentRequested(path); });
        m_recent->addWidget(button);
    }
}

} // namespace ui
