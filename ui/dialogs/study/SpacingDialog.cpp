// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/study/SpacingDialog.h"

#include "core/repair/SeriesRepair.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/widgets/fields/NumberField.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int decimals = 6;
constexpr double mostMm = 10000.0;

QLabel* smallText(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setFont(theme::smallFont());
    label->setProperty("role", QStringLiteral("secondary"));
    return label;
}

/// Trailing zeros say nothing of a length; and what stands there gives way to what is typed, also
/// after a click: no digit goes in between the letters of "not said".
class LengthField : public NumberField {
public:
    using NumberField::NumberField;
    [[nodiscard]] QString textFromValue(double value) const override
    {
        return locale().toString(value, 'g', 10);
    }

protected:
    void focusInEvent(QFocusEvent* event) override
    {
        NumberField::focusInEvent(event);
        QTimer::singleShot(0, this, &QDoubleSpinBox::selectAll);
    }
};

QString whereFrom(const glm::dvec3& saidMm)
{
    if (saidMm.x > 0.0)
        return SpacingDialog::tr("The distances within a slice are those that the files name; "
                                 "check them.");
    return {};
}

} // namespace

SpacingDialog::SpacingDialog(const core::SeriesEntry& entry, QWidget* parent)
    : QDialog(parent)
    , m_size(entry.geometry.size)
{
    setWindowTitle(tr("How large are the voxels?"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 16);
    layout->setSpacing(theme::smallPadding);
    auto* heading = new QLabel(m_size.z == 1
            ? tr("%1 is a picture of %2 × %3 pixels that does not say how large they are.")
                  .arg(entry.key)
                  .arg(m_size.x)
                  .arg(m_size.y)
            : tr("%1 holds %2 pictures of %3 × %4 pixels that do not say how large these are, nor "
                 "how far apart the slices lie.")
                  .arg(entry.key)
                  .arg(m_size.z)
                  .arg(m_size.x)
                  .arg(m_size.y),
        this);
    heading->setTextFormat(Qt::PlainText);
    heading->setWordWrap(true);
    heading->setMinimumWidth(420);
    layout->addWidget(heading);
    const glm::dvec3 said = entry.saidSpacingMm.value_or(glm::dvec3(0.0));
    buildFields(said);
    m_extent = new QLabel(this);
    m_extent->setObjectName(QStringLiteral("spacingExtent"));
    layout->addWidget(m_extent);
    if (const QString from = whereFrom(said); !from.isEmpty())
        layout->addWidget(smallText(from, this));
    layout->addWidget(smallText(
        tr("Columns are taken to run to the left of the patient, rows to posterior, slices in the "
           "order of their names to superior. Lengths and volumes are as right as what you "
           "say here; the session keeps it."),
        this));

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    m_open = buttons->button(QDialogButtonBox::Open);
    m_open->setProperty("role", QStringLiteral("primary"));
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(buttons);
    tabAsLaidOut(*this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showExtent();
}

void SpacingDialog::buildFields(const glm::dvec3& saidMm)
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(theme::smallPadding);
    grid->setVerticalSpacing(4);
    const std::array<QString, 3> names{
        tr("Between &columns"), tr("Between &rows"), tr("Between &slices")};
    const std::array<const char*, 3> ids{"spacingColumns", "spacingRows", "spacingSlices"};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = new LengthField(this);
        m_fields[std::size_t(axis)] = field;
        field->setObjectName(QLatin1String(ids[std::size_t(axis)]));
        field->setDecimals(decimals);
        field->setRange(0.0, mostMm);
        field->setSingleStep(0.1);
        field->setSpecialValueText(tr("not said"));
        field->setSuffix(tr(" mm"));
        field->setValue(saidMm[axis]);
        field->setFixedHeight(theme::controlHeight);
        field->setMinimumWidth(140);
        auto* label = new QLabel(names[std::size_t(axis)], this);
        label->setBuddy(field);
        grid->addWidget(label, axis, 0);
        grid->addWidget(field, axis, 1);
        connect(field, &QDoubleSpinBox::valueChanged, this, &SpacingDialog::showExtent);
    }
    // A picture alone is as thick as its pixels are wide until somebody knows better.
    if (m_size.z == 1 && saidMm.z <= 0.0)
        m_fields[2]->setValue(saidMm.x);
    grid->setColumnStretch(2, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
    const auto empty = std::find_if(m_fields.begin(), m_fields.end(),
        [](const QDoubleSpinBox* field) { return field->value() <= 0.0; });
    if (empty != m_fields.end()) {
        (*empty)->setFocus();
        (*empty)->selectAll();
    }
}

void SpacingDialog::showExtent()
{
    const bool isSaid = std::all_of(m_fields.begin(), m_fields.end(),
        [](const QDoubleSpinBox* field) { return field->value() > 0.0; });
    if (m_open != nullptr)
        m_open->setEnabled(isSaid);
    if (m_extent == nullptr)
        return;
    const auto extent = [this](int axis) {
        return locale().toString(
            m_fields[std::size_t(axis)]->value() * double(m_size[axis]), 'g', 4);
    };
    m_extent->setText(isSaid
            ? tr("The volume measures %1 × %2 × %3 mm.").arg(extent(0), extent(1), extent(2))
            : tr("It opens when all three are given."));
}

QString SpacingDialog::repair() const
{
    QStringList sizes;
    for (const QDoubleSpinBox* field : m_fields)
        sizes += QString::number(field->value(), 'g', 12);
    return core::spacingWord(sizes.join(u',')).value_or(QString());
}

} // namespace ui
