// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/MeasurementsPanel.h"

#include "core/edits/kinds/views/Measurements.h"
#include "core/export/MeasurementsCsv.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/export/SuggestedTarget.h"
#include "ui/measure/MeasureTexts.h"
#include "ui/overlays/MeasurementLines.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>
#include <vector>

namespace ui {

namespace {

constexpr int mostMeasurementRows = 6;
constexpr int numberRole = Qt::UserRole;

/// "3 · ellipse · 120.4 mm²", and below it what else it comes to.
QString rowText(const core::Measurement& measurement, const Workspace& workspace)
{
    QStringList lines = measurementLines(measurement, workspace);
    QStringList head{QString::number(measurement.id), kindText(measurement.kind)};
    if (!lines.isEmpty())
        head += lines.takeFirst();
    QString text = head.join(QStringLiteral(" · "));
    // A row is broken between what it comes to, not within "2 … 53 HU".
    lines.replaceInStrings(QStringLiteral(" "), QString(QChar::Nbsp));
    if (!lines.isEmpty())
        text += QLatin1Char('\n') + lines.join(QStringLiteral(" · "));
    return text;
}

} // namespace

MeasurementsPanel::MeasurementsPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_list(new QListWidget(this))
    , m_save(new QPushButton(tr("Save as CSV …"), this))
    , m_remove(new QPushButton(tr("Remove"), this))
{
    m_list->setObjectName(QStringLiteral("measurementList"));
    m_list->setAccessibleName(tr("Measurements"));
    m_list->setWordWrap(true);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setToolTip(tr("A click leads the crosshair there; Del removes what is selected"));
    m_remove->setObjectName(QStringLiteral("removeMeasurements"));
    m_save->setObjectName(QStringLiteral("saveMeasurements"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, theme::smallPadding);
    layout->setSpacing(theme::smallPadding);
    auto* rows = new QHBoxLayout;
    rows->setContentsMargins(theme::padding - 3, 0, 0, 0);
    rows->addWidget(m_list);
    layout->addLayout(rows);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(theme::padding, 0, theme::padding, 0);
    buttons->addWidget(m_save);
    buttons->addStretch();
    buttons->addWidget(m_remove);
    layout->addLayout(buttons);

    connect(m_list, &QListWidget::itemClicked, this, &MeasurementsPanel::lead);
    connect(m_list, &QListWidget::itemActivated, this, &MeasurementsPanel::lead);
    connect(m_list, &QListWidget::itemSelectionChanged, this,
        [this] { m_remove->setEnabled(!m_list->selectedItems().isEmpty()); });
    connect(m_save, &QPushButton::clicked, this, &MeasurementsPanel::save);
    connect(m_remove, &QPushButton::clicked, this, &MeasurementsPanel::removeSelected);
    auto* del = new QShortcut(QKeySequence(Qt::Key_Delete), m_list);
    del->setContext(Qt::WidgetShortcut);
    connect(del, &QShortcut::activated, this, &MeasurementsPanel::removeSelected);
    connect(&workspace, &Workspace::sessionChanged, this, &MeasurementsPanel::refresh);
    connect(&workspace, &Workspace::measuredChanged, this, &MeasurementsPanel::refresh);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Measurements)
                refresh();
        });
    refresh();
}

QString MeasurementsPanel::title() const
{
    return tr("Measurements");
}

QString MeasurementsPanel::summary() const
{
    return m_list->count() > 0 ? QString::number(m_list->count()) : QString();
}

bool MeasurementsPanel::hasSomething() const
{
    const core::EditSession* session = m_workspace.session();
    return session && !session->document().measurements.empty();
}

/// How many lines a row has depends on the width.
void MeasurementsPanel::resizeEvent(QResizeEvent* event)
{
    Panel::resizeEvent(event);
    fitHeight();
}

void MeasurementsPanel::fitHeight()
{
    m_list->doItemsLayout();
    int height = 2 * m_list->frameWidth();
    for (int row = 0; row < std::min(m_list->count(), mostMeasurementRows); ++row)
        height += m_list->visualItemRect(m_list->item(row)).height();
    m_list->setFixedHeight(height);
}

void MeasurementsPanel::refresh()
{
    const core::EditSession* session = m_workspace.session();
    const std::vector<core::Measurement> none;
    const std::vector<core::Measurement>& all = session ? session->document().measurements : none;
    const auto count = int(all.size());
    // Rows stay where they can, so that what is selected does.
    for (int row = m_list->count() - 1; row >= 0; --row) {
        const int number = m_list->item(row)->data(numberRole).toInt();
        if (std::none_of(all.begin(), all.end(),
                [number](const core::Measurement& each) { return each.id == number; }))
            delete m_list->takeItem(row);
    }
    for (int row = 0; row < count; ++row) {
        const core::Measurement& measured = all[std::size_t(row)];
        const QListWidgetItem* present = m_list->item(row);
        if (!present || present->data(numberRole).toInt() != measured.id)
            m_list->insertItem(row, new QListWidgetItem);
        QListWidgetItem& item = *m_list->item(row);
        item.setData(numberRole, measured.id);
        item.setText(rowText(measured, m_workspace));
    }
    fitHeight();
    m_remove->setEnabled(!m_list->selectedItems().isEmpty());
    const bool known = std::all_of(all.begin(), all.end(),
        [this](const core::Measurement& each) { return m_workspace.measured(each) != nullptr; });
    m_save->setEnabled(count > 0 && known);
    m_save->setToolTip(known ? tr("All measurements as a table, with their values")
                             : tr("Some values are still being worked out"));
    Q_EMIT summaryChanged(summary());
    if (hasSomething() != m_hadSomething) {
        m_hadSomething = hasSomething();
        Q_EMIT hasSomethingChanged();
    }
}

void MeasurementsPanel::lead(const QListWidgetItem* item)
{
    const core::EditSession* session = m_workspace.session();
    const core::Measurement* measured =
        session ? session->document().measurement(item->data(numberRole).toInt()) : nullptr;
    if (measured)
        m_workspace.setCrosshairLps(middleOf(*measured));
}

void MeasurementsPanel::removeSelected()
{
    std::vector<int> numbers;
    for (const QListWidgetItem* item : m_list->selectedItems())
        numbers.push_back(item->data(numberRole).toInt());
    std::sort(numbers.begin(), numbers.end());
    for (const int number : numbers) {
        core::EditSession* session = m_workspace.session();
        if (!session)
            return;
        const core::RemoveMeasurement edit{.measurement = number};
        if (const auto removed = session->apply(edit); !removed)
            return m_workspace.fail(removed.error());
    }
}

void MeasurementsPanel::save()
{
    const auto chosen = askForTarget({.title = tr("Save measurements"),
                                         .of = tr("measurements"),
                                         .ending = QStringLiteral(".csv"),
                                         .filter = tr("Tables (*.csv)")},
        m_workspace.volume(), this);
    if (chosen)
        saveAs(chosen->file);
}

void MeasurementsPanel::saveAs(const QString& file)
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !m_workspace.volume())
        return;
    std::vector<core::Measured> all;
    for (const core::Measurement& each : session->document().measurements) {
        if (const core::Measured* known = m_workspace.measured(each))
            all.push_back(*known);
    }
    // The dialog has asked whether a file of that name is to be replaced.
    m_background.start(
        this,
        [all = std::move(all), volume = *m_workspace.volume(), file] {
            return core::exportMeasurements(all, volume, file, true);
        },
        [this, file](const core::Result<void>& saved) {
            if (!saved)
                m_workspace.fail(saved.error());
            else
                m_workspace.say(tr("Measurements saved and checked: %1").arg(file));
        });
}

} // namespace ui
