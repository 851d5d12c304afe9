// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/MarkedSeries.h"

#include "tests/support/servers/Python.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <array>
#include <stdexcept>

namespace test {

namespace {

void putText(DcmItem& item, const DcmTag& tag, const char* value)
{
    if (item.putAndInsertString(tag, value).bad())
        throw std::runtime_error("markedSeries: " + std::string(value));
}

void mark(DcmDataset& set, int k)
{
    for (const DcmTagKey& tag : {DCM_PatientName, DCM_ReferringPhysicianName, DCM_OperatorsName,
             DCM_PerformingPhysicianName, DCM_PatientBirthName, DCM_PatientMotherBirthName,
             DCM_PhysiciansOfRecord, DCM_RequestingPhysician, DCM_NameOfPhysiciansReadingStudy})
        putText(set, tag, "MARKERNAME^Otto");
    for (const DcmTagKey& tag :
        {DCM_PatientID, DCM_AccessionNumber, DCM_StudyID, DCM_RETIRED_OtherPatientIDs,
            DCM_PerformedProcedureStepID, DCM_ScheduledProcedureStepID})
        putText(set, tag, "MARKERID");
    for (const DcmTagKey& tag : {DCM_PatientComments, DCM_InstitutionName, DCM_InstitutionAddress,
             DCM_PatientAddress, DCM_AdditionalPatientHistory, DCM_ImageComments, DCM_Allergies,
             DCM_Occupation, DCM_StudyDescription, DCM_SeriesDescription, DCM_ProtocolName,
             DCM_InstitutionalDepartmentName, DCM_DerivationDescription,
             DCM_PerformedProcedureStepDescription, DCM_RequestedProcedureDescription,
             DCM_ContrastBolusAgent, DCM_EthnicGroup, DCM_MedicalAlerts, DCM_Manufacturer,
             DCM_ManufacturerModelName, DCM_SoftwareVersions})
        putText(set, tag, tag == DCM_EthnicGroup ? "MARKERTEXT" : "Kopf MARKERTEXT von MARKERNAME");
    for (const DcmTagKey& tag : {DCM_OtherPatientNames, DCM_ResponsiblePerson})
        putText(set, tag, "MARKERNAME^Otto");
    for (const DcmTagKey& tag :
        {DCM_PatientTelephoneNumbers, DCM_PatientReligiousPreference, DCM_CountryOfResidence,
            DCM_RegionOfResidence, DCM_MilitaryRank, DCM_BranchOfService,
            DCM_ResponsibleOrganization, DCM_CurrentPatientLocation,
            DCM_PatientInstitutionResidence, DCM_AdmittingDiagnosesDescription,
            DCM_ReasonForTheRequestedProcedure, DCM_RequestingService, DCM_SpecialNeeds,
            DCM_PatientState, DCM_ServiceEpisodeID, DCM_ServiceEpisodeDescription, DCM_AdmissionID})
        putText(set, tag, "MARKERTEXT");
    putText(set, DCM_Manufacturer, "Werk 7 MARKERNAME");
    for (const DcmTagKey& tag :
        {DCM_PatientBirthDate, DCM_StudyDate, DCM_SeriesDate, DCM_AcquisitionDate, DCM_ContentDate,
            DCM_InstanceCreationDate, DCM_PerformedProcedureStepStartDate})
        putText(set, tag, "19330214");
    for (const DcmTagKey& tag : {DCM_StationName, DCM_DeviceSerialNumber})
        putText(set, tag, "MARKERDEV");
    putText(set, DCM_AcquisitionDateTime, "19330214101112");
    putText(set, DCM_PatientAge, "077Y");
    putText(set, DCM_PatientWeight, "77.0770770770");
    for (const DcmTagKey& tag : {DCM_FrameOfReferenceUID, DCM_SynchronizationFrameOfReferenceUID})
        putText(set, tag, "2.25.7700770077003");
    putText(set, DCM_SOPInstanceUID, ("2.25.77007700770099" + std::to_string(k)).c_str());
    DcmItem* item = nullptr;
    for (const DcmTagKey& tag : {DCM_RequestAttributesSequence, DCM_ReferencedStudySequence,
             DCM_OtherPatientIDsSequence, DCM_ReferencedImageSequence}) {
        if (set.findOrCreateSequenceItem(tag, item, -2).bad())
            throw std::runtime_error("markedSeries: sequence");
        putText(*item, DCM_PatientID, "MARKERID");
        putText(*item, DCM_RequestedProcedureDescription, "MARKERTEXT");
        putText(*item, DCM_ReferencedSOPInstanceUID, "2.25.7700770077009");
    }
    putText(set, DcmTag(0x0009, 0x0010, EVR_LO), "MARKERTEXT");
    putText(set, DcmTag(0x0009, 0x1001, EVR_LO), "MARKERNAME");
    putText(set, DcmTag(0x6000, 0x4000, EVR_LT), "MARKERTEXT");
    putText(set, DcmTag(0x5000, 0x0030, EVR_SH), "MARKERTEXT");
    const std::array<Uint8, 12> bytes{'M', 'A', 'R', 'K', 'E', 'R', 'T', 'E', 'X', 'T', '0', '0'};
    set.putAndInsertUint8Array(DcmTag(0x0009, 0x1002, EVR_OB), bytes.data(), bytes.size());
    set.putAndInsertUint8Array(DcmTag(0x6000, 0x3000, EVR_OW), bytes.data(), bytes.size());
}

} // namespace

SyntheticSeries markedSeries()
{
    SyntheticSeries series;
    series.size = {16, 12, 6};
    series.studyUid = QStringLiteral("2.25.7700770077001");
    series.seriesUid = QStringLiteral("2.25.7700770077002");
    series.adjust = mark;
    return series;
}

QByteArrayList markers()
{
    return {"MARKERNAME", "MARKERID", "MARKERTEXT", "MARKERDEV", "MARKERPATH", "MARKERUSER",
        "19330214", "1933-02-14", "2.25.77007700", "77.0770770"};
}

QByteArrayList markersIn(const QString& file)
{
    QStringList arguments{file};
    for (const QByteArray& marker : markers())
        arguments += QString::fromLatin1(marker);
    const ScriptOutput found = runScript(QStringLiteral("markers.py"), arguments);
    if (found.exitCode != 0)
        return {"markers.py: " + found.errors.toUtf8()};
    return found.output.trimmed().isEmpty() ? QByteArrayList() : found.output.trimmed().split('\n');
}

} // namespace test
