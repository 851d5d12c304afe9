// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/SyntheticSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpls/djencode.h>

#include <QDir>
#include <QFile>

#include <mutex>

namespace test {

namespace {

void registerEncoders()
{
    static std::once_flag once;
    std::call_once(once, [] {
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        DJEncoderRegistration::registerCodecs();
        DJLSEncoderRegistration::registerCodecs();
        DcmRLEEncoderRegistration::registerCodecs();
    });
}

QByteArray decimals(const std::vector<double>& values)
{
    QByteArrayList texts;
    for (const double value : values)
        texts.append(QByteArray::number(value, 'g', 10));
    return texts.join('\\');
}

std::uint16_t cell(const SyntheticSeries& series, const glm::ivec3& index)
{
    const core::PixelLayout& layout = series.layout;
    const int shift = layout.highBit + 1 - layout.bitsStored;
    // In 64 bits, since all 32 of a word may be stored.
    const auto mask = std::uint32_t((std::uint64_t(1) << layout.bitsStored) - 1u);
    const std::uint32_t value = (std::uint32_t(series.stored(index)) & mask) << shift;
    const std::uint32_t dirt = series.dirtySpareBits
        ? std::uint32_t(index.x * 2654435761u + std::uint32_t(index.y) * 40503u) >> 3
        : 0u;
    return std::uint16_t(value | (dirt & ~(mask << shift)));
}

void putPixels(DcmDataset& set, const SyntheticSeries& series, int k)
{
    std::vector<std::uint16_t> words;
    std::vector<std::uint8_t> bytes;
    for (int j = 0; j < series.size.y; ++j) {
        for (int i = 0; i < series.size.x; ++i) {
            words.push_back(cell(series, {i, j, k}));
            bytes.push_back(std::uint8_t(words.back()));
        }
    }
    if (series.layout.bitsAllocated == 16)
        set.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size());
    else
        set.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size());
}

} // namespace

int SyntheticSeries::defaultStored(const glm::ivec3& index)
{
    return (index.x * 7 + index.y * 31 + index.z * 113) % 2048;
}

QString SyntheticSeries::shuffledName(int k)
{
    return QStringLiteral("image_%1").arg((k * 7 + 3) % 1009, 4, 10, QLatin1Char('0'));
}

double SyntheticSeries::value(const glm::ivec3& index) const
{
    return slope(index.z) * double(stored(index)) + intercept(index.z);
}

glm::dvec3 SyntheticSeries::position(int k) const
{
    return positions.empty() ? origin + step * double(k) : positions[std::size_t(k)];
}

QStringList writeSeries(const SyntheticSeries& series, const QString& folder)
{
    registerEncoders();
    QDir().mkpath(folder);
    QStringList files;
    for (int k = 0; k < series.size.z; ++k) {
        DcmFileFormat format;
        DcmDataset& set = *format.getDataset();
        const auto put = [&](const DcmTagKey& key, const QByteArray& value) {
            set.putAndInsertString(key, value.constData());
        };
        const auto putNumber = [&](const DcmTagKey& key, int value) {
            set.putAndInsertUint16(key, Uint16(value));
        };
        const glm::dvec3 position = series.position(k);
        const glm::dvec3& row = series.plane.row;
        const glm::dvec3& column = series.plane.column;
        put(DCM_SOPClassUID, UID_CTImageStorage);
        put(DCM_SOPInstanceUID,
            series.seriesUid.toLatin1() + QByteArrayLiteral(".") + QByteArray::number(k + 1));
        put(DCM_StudyInstanceUID, series.studyUid.toLatin1());
        put(DCM_SeriesInstanceUID, series.seriesUid.toLatin1());
        put(DCM_FrameOfReferenceUID, "2.25.4713");
        put(DCM_Modality, series.modality.toLatin1());
        put(DCM_PatientName, "Synthetic^Subject");
        put(DCM_PatientID, "SYN1");
        put(DCM_PatientBirthDate, "19700102");
        put(DCM_StudyDate, "20240131");
        put(DCM_SeriesDescription, "Made to order");
        put(DCM_SeriesNumber, "3");
        put(DCM_ImageType, "ORIGINAL\\PRIMARY\\AXIAL");
        // Against the slice order, as real scanners also write it.
        put(DCM_InstanceNumber, QByteArray::number(series.size.z - k));
        put(DCM_ImagePositionPatient, decimals({position.x, position.y, position.z}));
        put(DCM_ImageOrientationPatient,
            decimals({row.x, row.y, row.z, column.x, column.y, column.z}));
        put(DCM_PixelSpacing, decimals({series.spacing.y, series.spacing.x}));
        put(DCM_SliceThickness, "9");
        put(DCM_RescaleSlope, decimals({series.slope(k)}));
        put(DCM_RescaleIntercept, decimals({series.intercept(k)}));
        putNumber(DCM_Rows, series.size.y);
        putNumber(DCM_Columns, series.size.x);
        putNumber(DCM_SamplesPerPixel, 1);
        put(DCM_PhotometricInterpretation, series.layout.photometric.toLatin1());
        putNumber(DCM_BitsAllocated, series.layout.bitsAllocated);
        putNumber(DCM_BitsStored, series.layout.bitsStored);
        putNumber(DCM_HighBit, series.layout.highBit);
        putNumber(DCM_PixelRepresentation, series.layout.isSigned ? 1 : 0);
        putPixels(set, series, k);
        series.adjust(set, k);

        const E_TransferSyntax syntax =
            DcmXfer(series.transferSyntaxUid.toLatin1().constData()).getXfer();
        if (set.chooseRepresentation(syntax, nullptr).bad())
            qFatal("cannot encode %s", qPrintable(series.transferSyntaxUid));
        const QString file = folder + QLatin1Char('/') + series.fileName(k);
        if (format.saveFile(QFile::encodeName(file).constData(), syntax).bad())
            qFatal("cannot write %s", qPrintable(file));
        files.append(file);
    }
    return files;
}

} // namespace test
