// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/EditableSection.h"

#include "ui/base/Theme.h"
#include "ui/widgets/fields/ValueField.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPoint>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

using Where = EditableSettings::Where;

QCheckBox* choice(QWidget* parent, const char* name, const QString& text)
{
    auto* made = new QCheckBox(text, parent);
    made->setObjectName(QLatin1String(name));
    return made;
}

/// What an entry of the list of places stands for.
QPoint placeOf(Where where, int segment = 0)
{
    return {int(where), segment};
}

} // namespace

EditableSection::EditableSection(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_on(choice(this, "editableOn", tr("editable range: all tools change only voxels")))
    , m_byValue(choice(this, "editableByValue", tr("with values from")))
    , m_lower(valueField(this, "editableLower"))
    , m_upper(valueField(this, "editableUpper"))
    , m_where(new QComboBox(this))
    , m_boxed(choice(this, "editableBoxed", tr("in the clip box, or else in the box of growth")))
{
    m_on->setToolTip(tr("What lies outside of the range stays as it is, whatever tool is used"));
    m_where->setObjectName(QStringLiteral("editableWhere"));
    m_where->setFixedHeight(theme::controlHeight);
    m_where->setAccessibleName(tr("Inside or outside of which segments"));
    auto* interval = new QHBoxLayout;
    interval->setSpacing(theme::smallPadding);
    interval->addWidget(m_byValue);
    interval->addWidget(m_lower);
    interval->addWidget(new QLabel(tr("to"), this));
    interval->addWidget(m_upper);
    interval->addStretch(1);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(theme::smallPadding);
    rows->addWidget(m_on);
    rows->addLayout(interval);
    rows->addWidget(m_where);
    rows->addWidget(m_boxed);

    showSettings();
    connect(&m_workspace, &Workspace::editableChanged, this, &EditableSection::showSettings);
    for (const QCheckBox* each : {m_on, m_byValue, m_boxed})
        connect(each, &QCheckBox::clicked, this, &EditableSection::take);
    for (QDoubleSpinBox* each : {m_lower, m_upper}) {
        each->setFixedWidth(valueFieldWidth);
        connect(each, &QDoubleSpinBox::valueChanged, this, &EditableSection::takeValues);
    }
    connect(m_where, &QComboBox::activated, this, [this] {
        // Who chooses where voxels may change wants that to hold.
        if (m_where->currentData().toPoint() != placeOf(Where::Anywhere))
            m_on->setChecked(true);
        take();
    });
}

void EditableSection::showEvent(QShowEvent* event)
{
    showSettings();
    QWidget::showEvent(event);
}

void EditableSection::showSettings()
{
    const EditableSettings& settings = m_workspace.editableSettings();
    const QSignalBlocker lower(m_lower);
    const QSignalBlocker upper(m_upper);
    m_on->setChecked(settings.on);
    m_byValue->setChecked(settings.byValue);
    m_boxed->setChecked(settings.boxed);
    m_byValue->setEnabled(settings.on);
    m_boxed->setEnabled(settings.on && (settings.boxed || m_workspace.editableBox()));
    const core::Volume* volume = m_workspace.volume();
    for (QDoubleSpinBox* box : {m_lower, m_upper}) {
        box->setDecimals(volume ? valueFieldDecimals(volume->maximum - volume->minimum) : 0);
        box->setSuffix(volume ? QLatin1Char(' ') + volume->unit : QString());
        box->setEnabled(settings.on && settings.byValue);
    }
    m_lower->setValue(settings.lower);
    m_upper->setValue(settings.upper);
    listPlaces();
}

void EditableSection::listPlaces()
{
    const EditableSettings& settings = m_workspace.editableSettings();
    const QSignalBlocker blocker(m_where);
    m_where->clear();
    m_where->addItem(tr("anywhere"), placeOf(Where::Anywhere));
    m_where->addItem(tr("inside visible segments"), placeOf(Where::InsideVisible));
    m_where->addItem(tr("outside visible segments"), placeOf(Where::OutsideVisible));
    if (const core::EditSession* session = m_workspace.session()) {
        for (const core::Segment& segment : session->document().segments) {
            m_where->addItem(
                tr("inside %1").arg(segment.name), placeOf(Where::Inside, segment.label));
            m_where->addItem(
                tr("outside %1").arg(segment.name), placeOf(Where::Outside, segment.label));
        }
    }
    const bool isOfOne = settings.where == Where::Inside || settings.where == Where::Outside;
    const QPoint now = placeOf(settings.where, isOfOne ? settings.segment : 0);
    if (m_where->findData(now) < 0)
        m_where->addItem(settings.where == Where::Inside ? tr("inside a segment that is gone")
                                                         : tr("outside a segment that is gone"),
            now);
    m_where->setCurrentIndex(m_where->findData(now));
}

void EditableSection::take()
{
    EditableSettings settings = m_workspace.editableSettings();
    const bool wasByValue = settings.byValue;
    settings.on = m_on->isChecked();
    settings.byValue = m_byValue->isChecked();
    const QPoint place = m_where->currentData().toPoint();
    settings.where = Where(place.x());
    settings.segment = place.y();
    settings.boxed = m_boxed->isChecked();
    const core::Volume* volume = m_workspace.volume();
    if (settings.byValue && !wasByValue && settings.lower == settings.upper && volume) {
        // The growth's interval is what the user looks for more often than not.
        const Workspace::GrowSettings& growth = m_workspace.growSettings();
        const bool known = growth.lower < growth.upper;
        settings.lower = known ? growth.lower : volume->minimum;
        settings.upper = known ? growth.upper : volume->maximum;
    }
    m_workspace.setEditableSettings(settings);
}

/// Apart from the rest, since a box shows fewer digits than a value may have.
void EditableSection::takeValues()
{
    EditableSettings settings = m_workspace.editableSettings();
    (sender() == m_lower ? settings.lower : settings.upper) =
        (sender() == m_lower ? m_lower : m_upper)->value();
    m_workspace.setEditableSettings(settings);
}

} // namespace ui
