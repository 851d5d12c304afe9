// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/CtSeriesWriter.h"

#include "core/base/ParallelFor.h"
#include "core/dicom/write/SaveDicom.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

namespace core {

namespace {

constexpr int intercept = -1024;
constexpr int largestStored = 4095;

QByteArray number(double value)
{
    return QByteArray::number(value, 'g', 12); // DS holds 16 characters
}

QByteArray numbers(std::initializer_list<double> values)
{
    QByteArray text;
    for (const double value : values)
        text += (text.isEmpty() ? "" : "\\") + number(value);
    return text;
}

/// Puts elements and remembers the first failure.
class Dataset {
public:
    explicit Dataset(DcmDataset& dataset)
        : m_dataset(dataset)
    {
    }
    void text(const DcmTagKey& tag, const QString& value) { text(tag, value.toUtf8()); }
    void text(const DcmTagKey& tag, const QByteArray& value)
    {
        check(m_dataset.putAndInsertString(tag, value.constData()));
    }
    void date(const DcmTagKey& tag, const QString& value)
    {
        text(tag, QString(value).remove(QLatin1Char('-')));
    }
    void word(const DcmTagKey& tag, int value)
    {
        check(m_dataset.putAndInsertUint16(tag, static_cast<Uint16>(value)));
    }
    void pixels(const std::vector<Uint16>& stored)
    {
        check(m_dataset.putAndInsertUint16Array(DCM_PixelData, stored.data(), stored.size()));
    }
    [[nodiscard]] const OFCondition& condition() const { return m_condition; }

private:
    void check(const OFCondition& condition)
    {
        if (m_condition.good() && condition.bad())
            m_condition = condition;
    }
    DcmDataset& m_dataset;
    OFCondition m_condition = EC_Normal;
};

void putIdentity(Dataset& out, const CtSeries& series)
{
    const StudyIdentity& identity = series.identity;
    out.text(DCM_SpecificCharacterSet, QByteArray("ISO_IR 192"));
    out.date(DCM_StudyDate, identity.studyDate);
    out.date(DCM_SeriesDate, identity.studyDate);
    out.date(DCM_AcquisitionDate, identity.studyDate);
    out.date(DCM_ContentDate, identity.studyDate);
    for (const DcmTagKey& tag :
        {DCM_StudyTime, DCM_SeriesTime, DCM_AcquisitionTime, DCM_ContentTime})
        out.text(tag, QByteArray("120000"));
    out.text(DCM_AccessionNumber, identity.accessionNumber);
    out.text(DCM_Modality, QByteArray("CT"));
    out.text(DCM_Manufacturer, series.manufacturer);
    out.text(DCM_ReferringPhysicianName, QByteArray());
    out.text(DCM_StudyDescription, identity.studyDescription);
    out.text(DCM_SeriesDescription, identity.seriesDescription);
    out.text(DCM_PatientName, identity.patientName);
    out.text(DCM_PatientID, identity.patientId);
    out.date(DCM_PatientBirthDate, identity.birthDate);
    out.text(DCM_PatientSex, identity.sex);
    out.text(DCM_BodyPartExamined, series.bodyPart);
    out.text(DCM_StudyInstanceUID, identity.studyUid);
    out.text(DCM_SeriesInstanceUID, identity.seriesUid);
    out.text(DCM_StudyID, QByteArray("1"));
    out.text(DCM_SeriesNumber, identity.seriesNumber);
    out.text(DCM_FrameOfReferenceUID, identity.frameOfReferenceUid);
    out.text(DCM_PositionReferenceIndicator, QByteArray());
    out.text(DCM_PatientPosition, identity.patientPosition);
    out.text(DCM_ImageComments, series.comments);
}

OFCondition putSlice(DcmDataset& dataset, const CtSeries& series, int k)
{
    Dataset out(dataset);
    putIdentity(out, series);
    const VolumeGeometry& geometry = series.geometry;
    const glm::dvec3 spacing = geometry.spacingMm();
    const glm::dmat3 direction = geometry.direction();
    const glm::dvec3 position = geometry.toWorld({0.0, 0.0, k});
    out.text(DCM_SOPClassUID, QByteArray(UID_CTImageStorage));
    out.text(DCM_SOPInstanceUID, series.instanceUid(k));
    out.text(DCM_ImageType, QByteArray("ORIGINAL\\PRIMARY\\AXIAL"));
    out.text(DCM_KVP, QByteArray());
    out.text(DCM_AcquisitionNumber, QByteArray("1"));
    out.text(DCM_InstanceNumber, QByteArray::number(k + 1));
    out.text(DCM_SliceThickness, number(spacing.z));
    out.text(DCM_ImagePositionPatient, numbers({position.x, position.y, position.z}));
    out.text(DCM_ImageOrientationPatient,
        numbers({direction[0].x, direction[0].y, direction[0].z, direction[1].x, direction[1].y,
            direction[1].z}));
    out.text(DCM_PixelSpacing, numbers({spacing.y, spacing.x}));
    out.word(DCM_SamplesPerPixel, 1);
    out.text(DCM_PhotometricInterpretation, QByteArray("MONOCHROME2"));
    out.word(DCM_Rows, geometry.size.y);
    out.word(DCM_Columns, geometry.size.x);
    out.word(DCM_BitsAllocated, 16);
    out.word(DCM_BitsStored, 12);
    out.word(DCM_HighBit, 11);
    out.word(DCM_PixelRepresentation, 0);
    out.text(DCM_WindowCenter, number(series.window.centre));
    out.text(DCM_WindowWidth, number(series.window.width));
    out.text(DCM_RescaleIntercept, QByteArray::number(intercept));
    out.text(DCM_RescaleSlope, QByteArray("1"));
    out.text(DCM_RescaleType, QByteArray("HU"));

    const auto area =
        static_cast<std::size_t>(geometry.size.x) * static_cast<std::size_t>(geometry.size.y);
    const auto slice = series.hounsfield.subspan(area * static_cast<std::size_t>(k), area);
    std::vector<Uint16> stored(area);
    std::transform(slice.begin(), slice.end(), stored.begin(), [](int value) {
        return static_cast<Uint16>(std::clamp(value - intercept, 0, largestStored));
    });
    out.pixels(stored);
    return out.condition();
}

Result<void> writeSlice(const QString& file, const CtSeries& series, int k)
{
    DcmFileFormat format;
    const OFCondition condition = putSlice(*format.getDataset(), series, k);
    if (condition.bad())
        return failure(ErrorCode::FileUnwritable, file, QString::fromUtf8(condition.text()));
    return saveDicom(format, file, UID_LittleEndianExplicitTransferSyntax);
}

} // namespace

Result<void> writeCtSeries(const QString& folder, const CtSeries& series)
{
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    std::mutex guard;
    Result<void> result;
    std::atomic<bool> failed = false;
    parallelFor(series.geometry.size.z, [&](int k) {
        if (failed)
            return;
        const QString file =
            QStringLiteral("%1/CT%2.dcm").arg(folder).arg(k + 1, 4, 10, QLatin1Char('0'));
        const Result<void> written = writeSlice(file, series, k);
        if (written)
            return;
        const std::lock_guard lock(guard);
        failed = true;
        result = written;
    });
    return result;
}

} // namespace core
