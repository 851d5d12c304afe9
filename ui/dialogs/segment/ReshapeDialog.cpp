// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/ReshapeDialog.h"

#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/session/EditSession.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/segment/PreviewRow.h"
#include "ui/dialogs/segment/SegmentWorkRow.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <vector>

namespace ui {

namespace {

/// What can be chosen, in the order of the list.
struct Reshaping {
    const char* key; ///< of the setting that remembers its size
    core::ShapeOperation operation;
    std::optional<core::ShellPlace> shell{};
    QString text{};
    QString hint{}; ///< what it does, and what the millimetres are
    double usualMm = 2.0;
    bool isJoint = false; ///< all segments that are seen and not locked take part
};

const std::vector<Reshaping>& reshapings()
{
    using core::ShapeOperation;
    using core::ShellPlace;
    static const std::vector<Reshaping> all{
        {.key = "grow",
            .operation = ShapeOperation::Grow,
            .text = ReshapeDialog::tr("Grow by a margin"),
            .hint = ReshapeDialog::tr("Takes what is nearer to the segment than this.")},
        {.key = "shrink",
            .operation = ShapeOperation::Shrink,
            .text = ReshapeDialog::tr("Shrink by a margin"),
            .hint = ReshapeDialog::tr("Gives up what is nearer to its border than this.")},
        {.key = "hollowInside",
            .operation = ShapeOperation::Hollow,
            .shell = ShellPlace::Inside,
            .text = ReshapeDialog::tr("Hollow: a shell inside its border"),
            .hint = ReshapeDialog::tr("Leaves a shell of this thickness.")},
        {.key = "hollowCentred",
            .operation = ShapeOperation::Hollow,
            .shell = ShellPlace::Centred,
            .text = ReshapeDialog::tr("Hollow: a shell along its border"),
            .hint = ReshapeDialog::tr("Leaves a shell of this thickness, half of it outside.")},
        {.key = "hollowOutside",
            .operation = ShapeOperation::Hollow,
            .shell = ShellPlace::Outside,
            .text = ReshapeDialog::tr("Hollow: a shell outside its border"),
            .hint = ReshapeDialog::tr("Becomes a shell of this thickness around what it was.")},
        {.key = "median",
            .operation = ShapeOperation::Median,
            .text = ReshapeDialog::tr("Smooth by majority"),
            .hint =
                ReshapeDialog::tr("Each voxel follows most of those that are nearer than this."),
            .usualMm = 1.5},
        {.key = "gaussian",
            .operation = ShapeOperation::Gaussian,
            .text = ReshapeDialog::tr("Smooth by a Gaussian"),
            .hint = ReshapeDialog::tr("Rounds what is smaller than this standard deviation."),
            .usualMm = 1.0},
        {.key = "joint",
            .operation = ShapeOperation::Gaussian,
            .text = ReshapeDialog::tr("Smooth all shown segments together"),
            .hint =
                ReshapeDialog::tr("As by a Gaussian; neighbours stay neighbours. Not the locked."),
            .usualMm = 1.0,
            .isJoint = true},
        {.key = "open",
            .operation = ShapeOperation::Open,
            .text = ReshapeDialog::tr("Smooth by opening"),
            .hint = ReshapeDialog::tr("Removes what is thinner than a ball of this radius."),
            .usualMm = 1.5},
        {.key = "close",
            .operation = ShapeOperation::Close,
            .text = ReshapeDialog::tr("Smooth by closing"),
            .hint = ReshapeDialog::tr("Fills what is narrower than a ball of this radius."),
            .usualMm = 1.5},
        {.key = "wrap",
            .operation = ShapeOperation::Wrap,
            .text = ReshapeDialog::tr("Wrap and make solid"),
            .hint = ReshapeDialog::tr("Fills what a ball of this radius cannot get into."),
            .usualMm = 3.0},
    };
    return all;
}

/// The other segments that are shown and may be changed, by label; none: there is none.
std::optional<std::vector<int>> segmentsBeside(const Workspace& workspace, int label)
{
    const core::EditSession* session = workspace.session();
    if (!session)
        return std::nullopt;
    const core::Document document = session->foreseenDocument();
    std::vector<int> others;
    for (const core::Segment& each : document.segments) {
        if (each.label != label && each.visible && !each.locked)
            others.push_back(each.label);
    }
    std::sort(others.begin(), others.end());
    return others.empty() ? std::nullopt : std::optional(others);
}

QString settingOf(const Reshaping& reshaping)
{
    return QStringLiteral("reshape/") + QLatin1String(reshaping.key);
}

} // namespace

ReshapeDialog::ReshapeDialog(Workspace& workspace, QWidget* parent)
    : SegmentDialog(workspace, tr("Reshape a segment"), QStringLiteral("reshape"), parent)
    , m_operation(new QComboBox(this))
    , m_mm(new NumberField(this))
    , m_bySides(new QCheckBox(tr("not the same on all sides"), this))
    , m_hint(new QLabel(this))
    , m_preview(new PreviewRow(workspace, QStringLiteral("reshape"), this))
    , m_work(new SegmentWorkRow(workspace, QStringLiteral("Reshape"), tr("Apply"), this))
{
    m_operation->setObjectName(QStringLiteral("reshapeOperation"));
    m_operation->setAccessibleName(tr("What is done"));
    m_operation->setMinimumWidth(250);
    for (const Reshaping& each : reshapings())
        m_operation->addItem(each.text);
    constexpr double leastMm = 0.1;
    constexpr double mostMm = 100.0;
    m_mm->setObjectName(QStringLiteral("reshapeMm"));
    m_mm->setAccessibleName(tr("How far"));
    m_mm->setRange(leastMm, mostMm);
    m_mm->setDecimals(2);
    m_mm->setSingleStep(0.5);
    m_mm->setSuffix(tr(" mm"));
    m_mm->setAlignment(Qt::AlignRight);
    m_mm->setMinimumWidth(110);
    auto* row = new QHBoxLayout;
    row->setSpacing(theme::smallPadding);
    row->addWidget(m_operation, 1);
    row->addWidget(m_mm);
    m_hint->setFont(theme::smallFont());
    m_hint->setProperty("role", QStringLiteral("secondary"));
    int widest = 0; // of all of them, so that nothing moves when another is chosen
    for (const Reshaping& each : reshapings())
        widest = std::max(widest, m_hint->fontMetrics().horizontalAdvance(each.hint));
    m_hint->setMinimumWidth(widest);
    column().addLayout(row);
    column().addWidget(m_hint);
    m_bySides->setObjectName(QStringLiteral("reshapeBySides"));
    column().addWidget(m_bySides);
    QWidget* sides = sideFields();
    column().addWidget(sides);
    connect(m_bySides, &QCheckBox::toggled, this, &ReshapeDialog::showSides);
    addEditable();
    column().addSpacing(theme::smallPadding);
    column().addWidget(m_preview);
    column().addWidget(m_work);
    connect(m_operation, &QComboBox::currentIndexChanged, this, &ReshapeDialog::chooseOperation);
    connect(m_work, &SegmentWorkRow::asked, this, &ReshapeDialog::carryOut);
    connect(m_work, &SegmentWorkRow::looked, this, &ReshapeDialog::showState);
    connect(m_work, &SegmentWorkRow::closed, this, &QDialog::reject);
    connect(&workspace, &Workspace::documentChanged, this, &ReshapeDialog::showState);
    connect(&workspace, &Workspace::editableChanged, this, &ReshapeDialog::follow);
    connect(m_mm, &QDoubleSpinBox::valueChanged, this, &ReshapeDialog::follow);
    connect(m_preview, &PreviewRow::switched, this, &ReshapeDialog::follow);
    connect(m_preview, &PreviewRow::changed, this, [this] {
        m_work->follow();
        showState();
    });
    chooseOperation();
}

void ReshapeDialog::ask(int label, core::ShapeOperation first)
{
    setLabel(label);
    const std::vector<Reshaping>& all = reshapings();
    const auto found = std::find_if(
        all.begin(), all.end(), [first](const Reshaping& each) { return each.operation == first; });
    m_operation->setCurrentIndex(int(found - all.begin()));
    showState();
    bringUp();
    follow();
    m_mm->setFocus();
    m_mm->selectAll();
}

/// A field for each of the patient's sides, two by two.
QWidget* ReshapeDialog::sideFields()
{
    auto* sides = new QWidget(this);
    sides->setObjectName(QStringLiteral("reshapeSides"));
    auto* grid = new QGridLayout(sides);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(theme::smallPadding);
    const QStringList names{
        tr("Right"), tr("Left"), tr("Anterior"), tr("Posterior"), tr("Inferior"), tr("Superior")};
    constexpr double mostMm = 100.0;
    for (int side = 0; side < int(names.size()); ++side) {
        auto* mm = new NumberField(sides);
        mm->setObjectName(QStringLiteral("reshapeSide%1").arg(side));
        mm->setAccessibleName(names[side]);
        mm->setRange(0.0, mostMm);
        mm->setDecimals(2);
        mm->setSingleStep(0.5);
        mm->setSuffix(tr(" mm"));
        mm->setAlignment(Qt::AlignRight);
        auto* name = new QLabel(names[side], sides);
        name->setBuddy(mm);
        grid->addWidget(name, side / 2, side % 2 * 2);
        grid->addWidget(mm, side / 2, side % 2 * 2 + 1);
        connect(mm, &QDoubleSpinBox::valueChanged, this, &ReshapeDialog::follow);
        m_sides.push_back(mm);
    }
    return sides;
}

/// The fields begin with the margin that has held for all sides so far.
void ReshapeDialog::showSides()
{
    const core::ShapeOperation operation =
        reshapings()[std::size_t(m_operation->currentIndex())].operation;
    const bool isMargin =
        operation == core::ShapeOperation::Grow || operation == core::ShapeOperation::Shrink;
    auto* fields = findChild<QWidget*>(QStringLiteral("reshapeSides"));
    const bool show = isMargin && m_bySides->isChecked();
    if (show && fields->isHidden()) {
        for (QDoubleSpinBox* side : qAsConst(m_sides))
            side->setValue(m_mm->value());
    }
    m_bySides->setVisible(isMargin);
    fields->setVisible(show);
    m_mm->setEnabled(!show);
    follow();
}

void ReshapeDialog::chooseOperation()
{
    const Reshaping& reshaping = reshapings()[std::size_t(m_operation->currentIndex())];
    m_hint->setText(reshaping.hint);
    m_mm->setValue(QSettings().value(settingOf(reshaping), reshaping.usualMm).toDouble());
    showSides();
}

void ReshapeDialog::showState()
{
    SegmentDialog::showState();
    m_work->showWhyNot(whyUnchangeable(segment()));
    m_preview->showState(segment());
}

core::ReshapeSegment ReshapeDialog::chosen() const
{
    const Reshaping& reshaping = reshapings()[std::size_t(m_operation->currentIndex())];
    core::ReshapeSegment edit{.segment = label(),
        .operation = reshaping.operation,
        .mm = m_mm->value(),
        .shell = reshaping.shell};
    if (reshaping.operation == core::ShapeOperation::Median)
        edit.flat = true;
    if (reshaping.isJoint)
        edit.with = segmentsBeside(workspace(), label());
    if (m_bySides->isVisibleTo(this) && m_bySides->isChecked())
        edit.sides = {.rightMm = m_sides[0]->value(),
            .leftMm = m_sides[1]->value(),
            .anteriorMm = m_sides[2]->value(),
            .posteriorMm = m_sides[3]->value(),
            .inferiorMm = m_sides[4]->value(),
            .superiorMm = m_sides[5]->value()};
    edit.editable = workspace().editableRange();
    return edit;
}

void ReshapeDialog::follow()
{
    if (isVisible())
        m_preview->preview(whyUnchangeable(segment()).isEmpty()
                ? std::optional<core::Edit>(chosen())
                : std::nullopt);
}

void ReshapeDialog::carryOut()
{
    QSettings().setValue(
        settingOf(reshapings()[std::size_t(m_operation->currentIndex())]), m_mm->value());
    const core::ReshapeSegment edit = chosen();
    reshapeSegment(workspace(), edit, m_preview->handOver(edit));
    m_work->follow();
    showState();
}

} // namespace ui
