// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/SeedOptions.h"

#include "ui/base/Theme.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QSignalBlocker>
#include <QStyleOptionComboBox>
#include <QStylePainter>

namespace ui {

namespace {

/// Ends a name that is too long with "…", where Qt cuts it.
class SegmentBox : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        QStylePainter painter(this);
        QStyleOptionComboBox option;
        initStyleOption(&option);
        const QRect field = style()->subControlRect(
            QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
        constexpr int gapPixels = 8; // between the swatch and the name, and behind it
        const int swatch = option.currentIcon.isNull() ? 0 : option.iconSize.width();
        option.currentText = fontMetrics().elidedText(
            option.currentText, Qt::ElideRight, field.width() - swatch - gapPixels);
        painter.drawComplexControl(QStyle::CC_ComboBox, option);
        painter.drawControl(QStyle::CE_ComboBoxLabel, option);
    }
};

} // namespace

SeedOptions::SeedOptions(Workspace& workspace, const QString& label, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_segments(new SegmentBox(this))
{
    m_segments->setObjectName(QStringLiteral("seedSegment"));
    m_segments->setFixedHeight(theme::controlHeight);
    m_segments->setMinimumWidth(140);
    m_segments->setMaximumWidth(180);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    if (!label.isEmpty())
        layout->addWidget(new QLabel(label, this));
    layout->addWidget(m_segments);

    showSegments();
    connect(m_segments, &QComboBox::activated, this, &SeedOptions::takeSegment);
    connect(&m_workspace, &Workspace::sessionChanged, this, &SeedOptions::showSegments);
    connect(&m_workspace, &Workspace::activeSegmentChanged, this, &SeedOptions::showSegments);
    connect(&m_workspace, &Workspace::documentChanged, this,
        [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Segments)
                showSegments();
        });
}

void SeedOptions::showSegments()
{
    const QSignalBlocker blocker(m_segments);
    m_segments->clear();
    if (const core::EditSession* session = m_workspace.session()) {
        for (const core::Segment& segment : session->document().segments) {
            QPixmap swatch(12, 12);
            swatch.fill(QColor(segment.rgb));
            m_segments->addItem(QIcon(swatch), segment.name, int(segment.label));
        }
    }
    m_segments->addItem(tr("a new segment"), 0);
    m_segments->setCurrentIndex(m_segments->findData(m_workspace.activeSegment()));
    if (m_segments->currentIndex() < 0)
        m_segments->setCurrentIndex(m_segments->count() - 1);
}

void SeedOptions::takeSegment(int row)
{
    const int label = m_segments->itemData(row).toInt();
    if (label != 0) {
        m_workspace.setActiveSegment(label);
    } else if (const auto added = addSegment(m_workspace); !added) {
        m_workspace.fail(added.error());
        showSegments();
    }
}

} // namespace ui
