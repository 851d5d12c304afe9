// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/ImageHeaderReader.h"

#include "core/dicom/DicomFile.h"
#include "core/dicom/DicomText.h"
#include "core/dicom/TransferSyntax.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QFile>

#include <algorithm>
#include <cmath>
#include <exception>

namespace core {

namespace {

/// Typed look at one data set.
class Attributes {
public:
    explicit Attributes(DcmDataset& set)
        : m_set(set)
        , m_characterSet(bytes(DCM_SpecificCharacterSet))
    {
    }

    [[nodiscard]] QByteArray bytes(const DcmTagKey& key) const
    {
        OFString value;
        if (m_set.findAndGetOFStringArray(key, value).bad())
            return {};
        return QByteArray(value.c_str(), qsizetype(value.size()));
    }
    [[nodiscard]] QString text(const DcmTagKey& key) const
    {
        return dicomText(bytes(key), m_characterSet);
    }
    [[nodiscard]] int integer(const DcmTagKey& key, int otherwise = 0) const
    {
        Uint16 value = 0;
        return m_set.findAndGetUint16(key, value).good() ? int(value) : otherwise;
    }
    [[nodiscard]] std::vector<double> numbers(const DcmTagKey& key) const
    {
        std::vector<double> values;
        const QByteArray all = bytes(key);
        if (all.isEmpty())
            return values;
        for (const QByteArray& one : all.split('\\')) {
            const std::optional<double> value =
                dicomNumber(std::string_view(one.constData(), std::size_t(one.size())));
            if (!value)
                return {};
            values.push_back(*value);
        }
        return values;
    }
    [[nodiscard]] std::optional<double> number(const DcmTagKey& key) const
    {
        const std::vector<double> values = numbers(key);
        return values.empty() ? std::nullopt : std::optional<double>(values.front());
    }
    [[nodiscard]] bool has(const DcmTagKey& key) const { return m_set.tagExists(key); }

private:
    DcmDataset& m_set;
    QByteArray m_characterSet;
};

struct PhaseAttribute {
    DcmTagKey key;
    const char* name;
};

const std::vector<PhaseAttribute>& phaseAttributes()
{
    // The order of DICOM.md 1.3: what names a phase first, what merely differs with it last.
    static const std::vector<PhaseAttribute> table{
        {DCM_TemporalPositionIdentifier, "temporal position"},
        {DCM_NominalPercentageOfCardiacPhase, "cardiac phase"},
        {DCM_TriggerTime, "trigger time"},
        {DCM_EchoNumbers, "echo"},
        {DCM_EchoTime, "echo time"},
        {DCM_DiffusionBValue, "b-value"},
        {DCM_ImageType, "image type"},
        {DCM_AcquisitionNumber, "acquisition"},
        {DCM_AcquisitionDateTime, "acquisition time"},
        {DCM_AcquisitionTime, "acquisition time"},
        {DCM_ContentTime, "content time"},
    };
    return table;
}

StudyIdentity readIdentity(const Attributes& from)
{
    return {.patientName = from.text(DCM_PatientName),
        .patientId = from.text(DCM_PatientID),
        .birthDate = dicomDate(from.text(DCM_PatientBirthDate)),
        .sex = from.text(DCM_PatientSex),
        .studyUid = from.text(DCM_StudyInstanceUID),
        .studyDate = dicomDate(from.text(DCM_StudyDate)),
        .studyDescription = from.text(DCM_StudyDescription),
        .accessionNumber = from.text(DCM_AccessionNumber),
        .seriesUid = from.text(DCM_SeriesInstanceUID),
        .seriesNumber = from.text(DCM_SeriesNumber),
        .seriesDescription = from.text(DCM_SeriesDescription),
        .modality = from.text(DCM_Modality),
        .frameOfReferenceUid = from.text(DCM_FrameOfReferenceUID),
        .patientPosition = from.text(DCM_PatientPosition)};
}

PixelLayout readLayout(const Attributes& from)
{
    PixelLayout layout;
    layout.columns = from.integer(DCM_Columns);
    layout.rows = from.integer(DCM_Rows);
    layout.samplesPerPixel = from.integer(DCM_SamplesPerPixel, 1);
    layout.bitsAllocated = from.integer(DCM_BitsAllocated);
    layout.bitsStored = from.integer(DCM_BitsStored, layout.bitsAllocated);
    layout.highBit = from.integer(DCM_HighBit, layout.bitsStored - 1);
    layout.isSigned = from.integer(DCM_PixelRepresentation) == 1;
    layout.photometric = from.text(DCM_PhotometricInterpretation);
    return layout;
}

void readPlane(const Attributes& from, ImageHeader& header)
{
    const std::vector<double> position = from.numbers(DCM_ImagePositionPatient);
    if (position.size() == 3)
        header.position = glm::dvec3(position[0], position[1], position[2]);
    const std::vector<double> cosines = from.numbers(DCM_ImageOrientationPatient);
    if (cosines.size() == 6) {
        const glm::dvec3 row(cosines[0], cosines[1], cosines[2]);
        const glm::dvec3 column(cosines[3], cosines[4], cosines[5]);
        constexpr double tolerance = 1e-2;
        const bool sound = std::abs(glm::length(row) - 1.0) < tolerance
            && std::abs(glm::length(column) - 1.0) < tolerance
            && std::abs(glm::dot(row, column)) < tolerance;
        if (sound)
            header.plane = ImagePlane{glm::normalize(row), glm::normalize(column)};
    }
    // First the distance between rows, then the one between columns (PS3.3 10.7.1.3).
    const std::vector<double> spacing = from.numbers(DCM_PixelSpacing);
    if (spacing.size() == 2 && spacing[0] > 0.0 && spacing[1] > 0.0)
        header.spacing = glm::dvec2(spacing[1], spacing[0]);
    header.sliceThickness = std::max(0.0, from.number(DCM_SliceThickness).value_or(0.0));
    header.spacingBetweenSlices = std::abs(from.number(DCM_SpacingBetweenSlices).value_or(0.0));
}

void readValues(const Attributes& from, ImageHeader& header)
{
    const std::optional<double> slope = from.number(DCM_RescaleSlope);
    const std::optional<double> intercept = from.number(DCM_RescaleIntercept);
    header.hasRescale = slope && intercept && *slope != 0.0;
    header.slope = slope && *slope != 0.0 ? *slope : 1.0;
    header.intercept = intercept.value_or(0.0);
    header.rescaleType = from.text(DCM_RescaleType);
    header.units = from.text(DCM_Units);
    header.hasModalityLut = from.has(DCM_ModalityLUTSequence);
    const std::optional<double> centre = from.number(DCM_WindowCenter);
    const std::optional<double> width = from.number(DCM_WindowWidth);
    if (centre && width && *width >= 1.0)
        header.window = WindowLevel{*centre, *width};
}

Result<ImageHeader> read(const QString& path)
{
    const Result<DicomFile> file = DicomFile::open(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    DcmDataset set;
    if (const Result<void> parsed = file->readInto(set); !parsed)
        return tl::unexpected<Error>(parsed.error());

    const Attributes from(set);
    ImageHeader header;
    header.file = path;
    header.identity = readIdentity(from);
    header.sopInstanceUid = from.text(DCM_SOPInstanceUID);
    header.sopClassUid = from.text(DCM_SOPClassUID);
    header.transferSyntaxUid = file->transferSyntaxUid();
    header.imageType = from.text(DCM_ImageType).split(QLatin1Char('\\'));
    header.hasPixels = file->hasPixels();
    header.pixelsCut = file->pixelsCut();
    header.isEnhanced = from.has(DCM_SharedFunctionalGroupsSequence)
        || from.has(DCM_PerFrameFunctionalGroupsSequence);
    header.isLossy = from.text(DCM_LossyImageCompression) == QLatin1String("01")
        || transferSyntax(header.transferSyntaxUid).lossy;
    header.frames = int(std::clamp(from.number(DCM_NumberOfFrames).value_or(1.0), 1.0, 1e6));
    header.layout = readLayout(from);
    if (file->hasPixels() && !file->isEncapsulated()) {
        const PixelLayout& layout = header.layout;
        const auto needed = std::uint64_t(layout.columns) * std::uint64_t(layout.rows)
            * std::uint64_t(layout.samplesPerPixel) * std::uint64_t(layout.bitsAllocated) / 8;
        header.pixelsCut = header.pixelsCut || file->pixelBytes() < needed;
    }
    readPlane(from, header);
    readValues(from, header);
    header.instanceNumber =
        int(std::clamp(from.number(DCM_InstanceNumber).value_or(0.0), -2e9, 2e9));
    for (const PhaseAttribute& attribute : phaseAttributes())
        header.phases.push_back(from.text(attribute.key));
    if (header.sopClassUid.isEmpty()) {
        // DICOMDIR and files that lost the attribute still say it in their file meta information.
        header.sopClassUid = file->mediaSopClassUid();
    }
    return header;
}

} // namespace

const std::vector<QString>& phaseAttributeNames()
{
    static const std::vector<QString> names = [] {
        std::vector<QString> all;
        for (const PhaseAttribute& attribute : phaseAttributes())
            all.push_back(QString::fromLatin1(attribute.name));
        return all;
    }();
    return names;
}

Result<ImageHeader> readImageHeader(const QString& path)
{
    try {
        return read(path);
    } catch (const std::exception& exception) {
        return failure(ErrorCode::FileUnreadable, path, QString::fromLatin1(exception.what()));
    }
}

} // namespace core
