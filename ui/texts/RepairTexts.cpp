// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/RepairTexts.h"

#include "ui/texts/ClauseText.h"

#include <QCoreApplication>
#include <QStringList>

namespace ui {

namespace {

using core::RepairOffer;

struct RepairTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::RepairTexts)
};

QString millimetres(double value)
{
    return QString::number(value, 'g', 4);
}

QString tiltEffect(const RepairOffer& offer)
{
    QStringList room;
    if (offer.columns > 0)
        room += offer.columns == 1
            ? RepairTexts::tr("1 column")
            : RepairTexts::tr("%1 columns", nullptr, offer.columns).arg(offer.columns);
    if (offer.rows > 0)
        room += offer.rows == 1 ? RepairTexts::tr("1 row")
                                : RepairTexts::tr("%1 rows", nullptr, offer.rows).arg(offer.rows);
    return RepairTexts::tr("Every slice is shifted in its own plane until all lie straight behind "
                           "each other; %1slices lie %2 mm apart.")
        .arg(room.isEmpty() ? QString()
                            : RepairTexts::tr("the picture grows by %1, and ")
                                  .arg(room.join(RepairTexts::tr(" and "))),
            millimetres(offer.result.spacingMm().z));
}

} // namespace

QString repairTitle(const RepairOffer& offer)
{
    using Kind = RepairOffer::Kind;
    switch (offer.kind) {
    case Kind::ShearTilt:
        return RepairTexts::tr("Shear the tilt out");
    case Kind::FillGaps:
        return offer.made == 1 ? RepairTexts::tr("Fill the gap") : RepairTexts::tr("Fill the gaps");
    case Kind::EvenSpacing:
        return RepairTexts::tr("Resample to even spacing");
    case Kind::Part:
        return offer.first == offer.last
            ? RepairTexts::tr("Split: slice %1 only").arg(offer.first)
            : RepairTexts::tr("Split: slices %1–%2 only").arg(offer.first).arg(offer.last);
    case Kind::FirstDuplicates:
        return RepairTexts::tr("Drop duplicates, keep the first");
    case Kind::LastDuplicates:
        return RepairTexts::tr("Drop duplicates, keep the last");
    case Kind::GivenSpacing: {
        const glm::dvec3 spacing = offer.result.spacingMm();
        return RepairTexts::tr("%1 × %2 × %3 mm")
            .arg(millimetres(spacing.x), millimetres(spacing.y), millimetres(spacing.z));
    }
    case Kind::OtherStack:
        return RepairTexts::tr("Open %1").arg(clauseText(offer.stack));
    case Kind::AsRepaired:
        return RepairTexts::tr("As repaired (%1)").arg(offer.repair);
    }
    return {};
}

QString repairEffect(const RepairOffer& offer)
{
    using Kind = RepairOffer::Kind;
    const glm::ivec3 size = offer.result.size;
    switch (offer.kind) {
    case Kind::ShearTilt:
        return tiltEffect(offer);
    case Kind::FillGaps:
        return RepairTexts::tr("%1 interpolated from the neighbouring slices, %2 keep their "
                               "values; all lie %3 mm apart.")
            .arg(offer.made == 1
                    ? RepairTexts::tr("1 slice is")
                    : RepairTexts::tr("%1 slices are", nullptr, offer.made).arg(offer.made),
                QString::number(offer.kept), millimetres(offer.result.spacingMm().z));
    case Kind::EvenSpacing:
        return RepairTexts::tr("%1 slices %2 mm apart, interpolated between the %3 that there are.")
            .arg(QString::number(size.z), millimetres(offer.result.spacingMm().z),
                QString::number(offer.kept));
    case Kind::Part:
        return RepairTexts::tr("Part %1 of %2 is opened alone, its voxels as they are.")
            .arg(offer.part)
            .arg(offer.parts);
    case Kind::FirstDuplicates:
        return RepairTexts::tr("Of several images at one place the one with the least instance "
                               "number is taken.");
    case Kind::LastDuplicates:
        return RepairTexts::tr("Of several images at one place the one with the greatest instance "
                               "number is taken.");
    case Kind::GivenSpacing:
        return RepairTexts::tr("As given on opening. Opened as it is, it asks for it again.");
    case Kind::OtherStack:
        return RepairTexts::tr("Another stack of the series: %1 × %2 × %3 voxels.")
            .arg(size.x)
            .arg(size.y)
            .arg(size.z);
    case Kind::AsRepaired:
        return {};
    }
    return {};
}

} // namespace ui
