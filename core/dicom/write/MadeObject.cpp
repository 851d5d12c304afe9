// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/MadeObject.h"

#include "core/dicom/base/NewUid.h"
#include "core/dicom/items/PatientHeader.h"

#include <QCoreApplication>
#include <QDateTime>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

int madeSeriesNumber(int from, const StudyIdentity& source)
{
    bool numbered = false;
    const int number = source.seriesNumber.toInt(&numbered);
    return from + (numbered && number > 0 && number < 1'000'000 ? number : 0);
}

MadeObject madeOf(const StudyIdentity& source, const char* sopClassUid, const char* modality,
    int from, const QString& what)
{
    return {.sopClassUid = sopClassUid,
        .modality = modality,
        .seriesNumber = madeSeriesNumber(from, source),
        .seriesDescription = what + QLatin1Char(' ') + source.seriesDescription};
}

MadeAt describeMadeObject(DcmItem* item, const MadeObject& object, const ItemWriter& items)
{
    const QDateTime now = QDateTime::currentDateTime();
    const MadeAt made{.date = now.toString(QStringLiteral("yyyyMMdd")),
        .time = now.toString(QStringLiteral("HHmmss"))};
    const QString version = QCoreApplication::applicationVersion();
    items.put(item, DCM_SOPClassUID, object.sopClassUid);
    items.put(item, DCM_SOPInstanceUID, newUid());
    items.put(item, DCM_InstanceCreationDate, made.date);
    items.put(item, DCM_InstanceCreationTime, made.time);
    items.put(item, DCM_Modality, object.modality);
    items.put(item, DCM_Manufacturer, "Burin");
    items.put(item, DCM_ManufacturerModelName, "Burin");
    items.put(
        item, DCM_SoftwareVersions, version.isEmpty() ? QStringLiteral("development") : version);
    items.put(item, DCM_SeriesInstanceUID, newUid());
    items.put(item, DCM_SeriesNumber, QString::number(object.seriesNumber));
    items.put(item, DCM_SeriesDescription, singleValueText(object.seriesDescription, 64));
    items.put(item, DCM_InstanceNumber, "1");
    return made;
}

void describeMadeContent(DcmItem* item, const MadeObject& object, const ItemWriter& items)
{
    const MadeAt made = describeMadeObject(item, object, items);
    for (const DcmTagKey& tag : {DCM_SeriesDate, DCM_ContentDate})
        items.put(item, tag, made.date);
    for (const DcmTagKey& tag : {DCM_SeriesTime, DCM_ContentTime})
        items.put(item, tag, made.time);
}

void takePatientAndStudy(DcmDataset& set, DcmDataset& header, ConditionChain& chain)
{
    for (DcmObject* object = header.nextInContainer(nullptr); object != nullptr;
         object = header.nextInContainer(object))
        chain(set.insert(static_cast<DcmElement*>(object->clone()), OFTrue), "patient and study");
    completePatientHeader(set, chain);
}

} // namespace core
