// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/CodeDetails.h"

#include "ui/base/SegmentCodes.h"

#include <QComboBox>
#include <QFormLayout>

namespace ui {

namespace {

core::CodedConcept sct(const char* value, const char* meaning)
{
    return {QStringLiteral("SCT"), QLatin1String(value), QLatin1String(meaning)};
}

void add(QComboBox* box, const core::CodedConcept& code)
{
    box->addItem(code.meaning, QStringList{code.scheme, code.value, code.meaning});
}

core::CodedConcept chosen(const QComboBox* box)
{
    const QStringList code = box->currentData().toStringList();
    return {code.value(0), code.value(1), code.value(2)};
}

void choose(QComboBox* box, const core::CodedConcept& code)
{
    const QStringList words{code.scheme, code.value, code.meaning};
    int at = code.isSet() ? box->findData(words) : 0;
    if (at < 0) {
        add(box, code);
        at = box->count() - 1;
    }
    box->setCurrentIndex(at);
}

/// DICOM CID 244 and what is commonly said beside it.
void addSides(QComboBox* box)
{
    box->addItem(QStringLiteral("–"));
    for (const core::CodedConcept& side : {sct("24028007", "Right"), sct("7771000", "Left"),
             sct("51440002", "Right and left"), sct("66459002", "Unilateral"),
             sct("255549009", "Anterior"), sct("255551008", "Posterior"),
             sct("264217000", "Superior"), sct("261089000", "Inferior")})
        add(box, side);
}

} // namespace

CodeDetails::CodeDetails(QWidget* parent)
    : QWidget(parent)
    , m_category(new QComboBox(this))
    , m_modifier(new QComboBox(this))
    , m_region(new QComboBox(this))
    , m_regionModifier(new QComboBox(this))
{
    m_category->setObjectName(QStringLiteral("codeCategory"));
    m_modifier->setObjectName(QStringLiteral("codeModifier"));
    m_region->setObjectName(QStringLiteral("codeRegion"));
    m_regionModifier->setObjectName(QStringLiteral("codeRegionModifier"));
    // DICOM CID 7150; the first is what a segment is unless something else is said.
    for (const core::CodedConcept& category : {sct("123037004", "Anatomical Structure"),
             sct("49755003", "Morphologically Altered Structure"), sct("85756007", "Tissue"),
             sct("260787004", "Physical object"), sct("105590001", "Substance"),
             sct("91720002", "Body Substance"), sct("309825002", "Spatial and Relational Concept")})
        add(m_category, category);
    addSides(m_modifier);
    m_region->addItem(QStringLiteral("–"));
    for (const SegmentCode& each : segmentCodes())
        add(m_region, each.code);
    addSides(m_regionModifier);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Category"), m_category);
    form->addRow(tr("Side or part"), m_modifier);
    form->addRow(tr("Lies in"), m_region);
    form->addRow(tr("Its side there"), m_regionModifier);
    alignLabels(*form);
}

void CodeDetails::alignLabels(const QFormLayout& form)
{
    constexpr int width = 132;
    for (int row = 0; row < form.rowCount(); ++row)
        form.itemAt(row, QFormLayout::LabelRole)->widget()->setMinimumWidth(width);
}

void CodeDetails::setCodes(const core::SegCodes& codes)
{
    choose(m_category, codes.category);
    choose(m_modifier, codes.modifier);
    choose(m_region, codes.region);
    choose(m_regionModifier, codes.regionModifier);
}

core::SegCodes CodeDetails::codes() const
{
    return {.category = chosen(m_category),
        .modifier = chosen(m_modifier),
        .region = chosen(m_region),
        .regionModifier = chosen(m_regionModifier)};
}

} // namespace ui
