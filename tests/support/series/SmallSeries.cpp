// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/SmallSeries.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/DicomText.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QDir>
#include <QFile>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <stdexcept>

namespace test {

namespace {

std::string decimalText(std::initializer_list<double> values)
{
    QStringList texts;
    for (const double value : values)
        texts += QString::number(value, 'g', 10);
    return texts.join(QLatin1Char('\\')).toStdString();
}

std::string uid()
{
    char text[100];
    return dcmGenerateUniqueIdentifier(text);
}

} // namespace

void SmallSeries::placeEvenly(const glm::dvec3& first, const glm::dvec3& step)
{
    positions.clear();
    for (int k = 0; k < size.z; ++k)
        positions.push_back(first + step * double(k));
}

core::Volume SmallSeries::write(const QString& folder) const
{
    core::readyDcmtk();
    core::Volume volume;
    volume.sourceFormat = QStringLiteral("DICOM");
    volume.sourcePath = folder;
    volume.identity.patientName = core::dicomText(
        QByteArray::fromStdString(patientName), QByteArray::fromStdString(characterSet));
    volume.identity.patientId = QString::fromStdString(patientId);
    volume.identity.birthDate = core::dicomDate(QString::fromStdString(birthDate));
    volume.identity.modality = QStringLiteral("CT");
    const std::string frame = uid();
    if (frameOfReference)
        volume.identity.frameOfReferenceUid = QString::fromStdString(frame);

    SyntheticSeries series;
    series.size = size;
    series.spacing = spacing;
    series.plane = {.row = rowDirection, .column = columnDirection};
    series.positions = positions;
    series.stored = [](const glm::ivec3&) { return 0; };
    series.studyUid = QString::fromStdString(uid());
    series.seriesUid = QString::fromStdString(uid());
    std::vector<std::string> instances(std::size_t(size.z));
    series.adjust = [&](DcmDataset& set, int k) {
        instances[std::size_t(k)] = uid();
        const auto put = [&](const DcmTagKey& tag, const std::string& value) {
            if (set.putAndInsertString(tag, value.c_str()).bad())
                throw std::runtime_error("SmallSeries: " + value);
        };
        put(DCM_SOPInstanceUID, instances[std::size_t(k)]);
        put(DCM_SpecificCharacterSet, characterSet);
        put(DCM_PatientName, patientName);
        put(DCM_PatientID, patientId);
        put(DCM_PatientBirthDate, birthDate);
        put(DCM_PatientSex, sex);
        put(DCM_StudyDate, studyDate);
        put(DCM_StudyTime, "101112");
        put(DCM_FrameOfReferenceUID, frame);
        if (!frameOfReference)
            set.findAndDeleteElement(DCM_FrameOfReferenceUID);
    };
    volume.identity.studyUid = series.studyUid;
    volume.identity.seriesUid = series.seriesUid;
    const QStringList files = writeSeries(series, folder);
    for (int k = 0; k < size.z; ++k) {
        volume.sources.push_back({.file = files[k],
            .sopInstanceUid = QString::fromStdString(instances[std::size_t(k)]),
            .sopClassUid = QStringLiteral(UID_CTImageStorage),
            .frame = 0,
            .instanceNumber = k + 1});
    }
    volume.geometry = geometry();
    return volume;
}

core::Volume SmallSeries::writeMultiFrame(const QString& folder) const
{
    core::Volume volume = write(folder);
    const QString file = QDir(folder).filePath(QStringLiteral("multi.dcm"));
    DcmFileFormat format;
    const QByteArray first = QFile::encodeName(volume.sources.front().file);
    if (format.loadFile(first.constData()).bad() || format.loadAllDataIntoMemory().bad())
        throw std::runtime_error("SmallSeries: cannot read back");
    DcmDataset& dataset = *format.getDataset();
    const std::string instance = uid();
    dataset.putAndInsertString(DCM_SOPClassUID, UID_EnhancedCTImageStorage);
    dataset.putAndInsertString(DCM_SOPInstanceUID, instance.c_str());
    dataset.putAndInsertString(DCM_NumberOfFrames, std::to_string(size.z).c_str());
    for (const DcmTagKey& tag : {DCM_ImagePositionPatient, DCM_ImageOrientationPatient,
             DCM_PixelSpacing, DCM_SliceThickness})
        dataset.findAndDeleteElement(tag);
    const auto macro = [&](const DcmTagKey& groups, long item, const DcmTagKey& sequence) {
        DcmItem* group = nullptr;
        DcmItem* found = nullptr;
        dataset.findOrCreateSequenceItem(groups, group, item);
        group->findOrCreateSequenceItem(sequence, found, 0);
        return found;
    };
    macro(DCM_SharedFunctionalGroupsSequence, 0, DCM_PlaneOrientationSequence)
        ->putAndInsertString(DCM_ImageOrientationPatient,
            decimalText({rowDirection.x, rowDirection.y, rowDirection.z, columnDirection.x,
                            columnDirection.y, columnDirection.z})
                .c_str());
    macro(DCM_SharedFunctionalGroupsSequence, 0, DCM_PixelMeasuresSequence)
        ->putAndInsertString(DCM_PixelSpacing, decimalText({spacing.y, spacing.x}).c_str());
    for (int frame = 0; frame < size.z; ++frame) {
        const int k = (frame + 2) % size.z;
        const glm::dvec3& p = positions[std::size_t(k)];
        macro(DCM_PerFrameFunctionalGroupsSequence, frame, DCM_PlanePositionSequence)
            ->putAndInsertString(DCM_ImagePositionPatient, decimalText({p.x, p.y, p.z}).c_str());
        core::SourceSlice& slice = volume.sources[std::size_t(k)];
        QFile::remove(slice.file);
        slice = {.file = file,
            .sopInstanceUid = QString::fromStdString(instance),
            .sopClassUid = QStringLiteral(UID_EnhancedCTImageStorage),
            .frame = frame,
            .instanceNumber = 1};
    }
    const std::vector<Uint16> pixels(volume.geometry.voxelCount(), 0);
    dataset.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
    if (format.saveFile(QFile::encodeName(file).constData(), EXS_LittleEndianExplicit).bad())
        throw std::runtime_error("SmallSeries: cannot write");
    return volume;
}

core::VolumeGeometry SmallSeries::geometry() const
{
    core::VolumeGeometry result;
    result.size = size;
    const glm::dvec3 step = size.z > 1 ? (positions.back() - positions.front()) / double(size.z - 1)
                                       : glm::cross(rowDirection, columnDirection);
    result.indexToWorld = {glm::dvec4(rowDirection * spacing.x, 0.0),
        glm::dvec4(columnDirection * spacing.y, 0.0), glm::dvec4(step, 0.0),
        glm::dvec4(positions.front(), 1.0)};
    for (int k = 0; k < size.z; ++k) {
        if (glm::distance(result.toWorld({0, 0, double(k)}), positions[std::size_t(k)]) > 0.01)
            result.slicePositions = positions;
    }
    return result;
}

} // namespace test
