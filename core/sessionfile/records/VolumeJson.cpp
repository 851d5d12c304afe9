// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/VolumeJson.h"

#include "core/repair/RepairLattice.h"

#include <QJsonArray>

#include <array>
#include <cmath>

namespace core {

namespace {

struct IdentityField {
    const char* key;
    QString StudyIdentity::*text;
};
const std::array<IdentityField, 14> identityFields{{
    {"patientName", &StudyIdentity::patientName},
    {"patientId", &StudyIdentity::patientId},
    {"birthDate", &StudyIdentity::birthDate},
    {"sex", &StudyIdentity::sex},
    {"studyUid", &StudyIdentity::studyUid},
    {"studyDate", &StudyIdentity::studyDate},
    {"studyDescription", &StudyIdentity::studyDescription},
    {"accessionNumber", &StudyIdentity::accessionNumber},
    {"seriesUid", &StudyIdentity::seriesUid},
    {"seriesNumber", &StudyIdentity::seriesNumber},
    {"seriesDescription", &StudyIdentity::seriesDescription},
    {"modality", &StudyIdentity::modality},
    {"frameOfReferenceUid", &StudyIdentity::frameOfReferenceUid},
    {"patientPosition", &StudyIdentity::patientPosition},
}};

struct ProblemName {
    VolumeProblem::Kind kind;
    const char* name;
};
const std::array<ProblemName, 11> problemNames{{
    {VolumeProblem::Kind::MissingSlices, "missingSlices"},
    {VolumeProblem::Kind::UnevenSpacing, "unevenSpacing"},
    {VolumeProblem::Kind::Tilt, "tilt"},
    {VolumeProblem::Kind::AssumedSpacing, "assumedSpacing"},
    {VolumeProblem::Kind::MixedSlices, "mixedSlices"},
    {VolumeProblem::Kind::DoubledSlices, "doubledSlices"},
    {VolumeProblem::Kind::DuplicateSlices, "duplicateSlices"},
    {VolumeProblem::Kind::DamagedSlice, "damagedSlice"},
    {VolumeProblem::Kind::LossyCompression, "lossyCompression"},
    {VolumeProblem::Kind::InexactValues, "inexactValues"},
    {VolumeProblem::Kind::Other, "other"},
}};

QLatin1String key(const char* text)
{
    return QLatin1String(text);
}

QJsonArray fromPoint(const glm::dvec3& point)
{
    return {point.x, point.y, point.z};
}

QJsonObject identityToJson(const StudyIdentity& identity)
{
    QJsonObject json;
    for (const IdentityField& field : identityFields) {
        if (!(identity.*field.text).isEmpty())
            json[key(field.key)] = identity.*field.text;
    }
    return json;
}

QJsonObject geometryToJson(const VolumeGeometry& geometry)
{
    QJsonArray matrix;
    for (int i = 0; i < 16; ++i)
        matrix.append(geometry.indexToWorld[i / 4][i % 4]);
    QJsonArray positions;
    for (const glm::dvec3& position : geometry.slicePositions)
        positions.append(fromPoint(position));
    return {
        {key("size"), QJsonArray{geometry.size.x, geometry.size.y, geometry.size.z}},
        {key("indexToWorld"), matrix},
        {key("slicePositions"), positions},
    };
}

std::optional<VolumeGeometry> geometryFromJson(const QJsonObject& json)
{
    const QJsonArray size = json[key("size")].toArray();
    const QJsonArray matrix = json[key("indexToWorld")].toArray();
    const QJsonArray positions = json[key("slicePositions")].toArray();
    if (size.size() != 3 || matrix.size() != 16)
        return {};
    VolumeGeometry geometry;
    for (int axis = 0; axis < 3; ++axis)
        geometry.size[axis] = size[axis].toInt();
    for (int i = 0; i < 16; ++i)
        geometry.indexToWorld[i / 4][i % 4] = matrix[i].toDouble();
    for (const QJsonValue& position : positions) {
        const QJsonArray xyz = position.toArray();
        geometry.slicePositions.emplace_back(
            xyz.at(0).toDouble(), xyz.at(1).toDouble(), xyz.at(2).toDouble());
    }
    constexpr int longest = 1 << 16;
    const bool sensible = geometry.size.x > 0 && geometry.size.y > 0 && geometry.size.z > 0
        && geometry.size.x <= longest && geometry.size.y <= longest && geometry.size.z <= longest
        && std::abs(glm::determinant(glm::dmat3(geometry.indexToWorld))) > 0.0
        && (positions.isEmpty() || positions.size() == geometry.size.z);
    return sensible ? std::optional(std::move(geometry)) : std::nullopt;
}

QJsonObject encodingToJson(const VoxelEncoding& encoding)
{
    return {
        {key("rescaleSlope"), encoding.rescaleSlope},
        {key("rescaleIntercept"), encoding.rescaleIntercept},
        {key("storedAtCodeZero"), encoding.storedAtCodeZero},
        {key("storedStep"), encoding.storedStep},
        {key("maxError"), encoding.maxError},
    };
}

std::optional<VoxelEncoding> encodingFromJson(const QJsonObject& json)
{
    const VoxelEncoding encoding{.rescaleSlope = json[key("rescaleSlope")].toDouble(),
        .rescaleIntercept = json[key("rescaleIntercept")].toDouble(),
        .storedAtCodeZero = json[key("storedAtCodeZero")].toInt(),
        .storedStep = json[key("storedStep")].toInt(),
        .maxError = json[key("maxError")].toDouble()};
    const bool rises = encoding.rescaleSlope * encoding.storedStep > 0.0;
    return rises ? std::optional(encoding) : std::nullopt;
}

QJsonArray sourcesToJson(const std::vector<SourceSlice>& sources)
{
    QJsonArray list;
    for (const SourceSlice& slice : sources) {
        list.append(QJsonObject{
            {key("file"), slice.file},
            {key("sopInstanceUid"), slice.sopInstanceUid},
            {key("sopClassUid"), slice.sopClassUid},
            {key("frame"), slice.frame},
            {key("instanceNumber"), slice.instanceNumber},
        });
    }
    return list;
}

std::vector<SourceSlice> sourcesFromJson(const QJsonArray& list)
{
    std::vector<SourceSlice> sources;
    for (const QJsonValue& value : list) {
        const QJsonObject json = value.toObject();
        sources.push_back({.file = json[key("file")].toString(),
            .sopInstanceUid = json[key("sopInstanceUid")].toString(),
            .sopClassUid = json[key("sopClassUid")].toString(),
            .frame = json[key("frame")].toInt(),
            .instanceNumber = json[key("instanceNumber")].toInt()});
    }
    return sources;
}

QJsonArray problemsToJson(const std::vector<VolumeProblem>& problems)
{
    QJsonArray list;
    for (const VolumeProblem& problem : problems) {
        QString kind;
        for (const ProblemName& name : problemNames) {
            if (name.kind == problem.kind)
                kind = key(name.name);
        }
        QJsonArray slices;
        for (const SliceSpan& span : problem.slices)
            slices.append(QJsonArray{span.first, span.last});
        list.append(QJsonObject{{key("kind"), kind}, {key("text"), storedText(problem.said)},
            {key("caution"), problem.caution}, {key("slices"), slices},
            {key("repairedBy"), problem.repairedBy}});
    }
    return list;
}

std::vector<VolumeProblem> problemsFromJson(const QJsonArray& list)
{
    std::vector<VolumeProblem> problems;
    for (const QJsonValue& value : list) {
        const QJsonObject json = value.toObject();
        VolumeProblem problem{.kind = VolumeProblem::Kind::Other,
            .said = {ProblemCode::AsStored, {json[key("text")].toString()}},
            .caution = json[key("caution")].toBool(),
            .slices = {},
            .repairedBy = json[key("repairedBy")].toString()};
        for (const QJsonValue& span : json[key("slices")].toArray())
            problem.slices.push_back(
                {.first = span.toArray().at(0).toInt(), .last = span.toArray().at(1).toInt()});
        for (const ProblemName& name : problemNames) {
            if (json[key("kind")].toString() == key(name.name))
                problem.kind = name.kind;
        }
        problems.push_back(std::move(problem));
    }
    return problems;
}

QJsonObject histogramToJson(const Histogram& histogram)
{
    QJsonArray counts;
    for (const std::uint32_t count : histogram.counts)
        counts.append(qint64(count));
    return {{key("minimum"), histogram.minimum}, {key("maximum"), histogram.maximum},
        {key("counts"), counts}};
}

Histogram histogramFromJson(const QJsonObject& json)
{
    Histogram histogram{.minimum = json[key("minimum")].toDouble(),
        .maximum = json[key("maximum")].toDouble(),
        .counts = {}};
    const QJsonArray counts = json[key("counts")].toArray();
    for (const QJsonValue& count : counts)
        histogram.counts.push_back(std::uint32_t(count.toInteger()));
    return histogram;
}

/// Whether a repair of such slices gives a grid of this size: the way back relies on it.
bool isGridOf(const VolumeGeometry& geometry, const VolumeGeometry& slices, const QString& repair)
{
    const std::optional<SeriesRepair> read = SeriesRepair::fromText(repair);
    return read && repairObstacle(slices, *read).isEmpty()
        && repairedGeometry(slices, *read).size == geometry.size;
}

} // namespace

QJsonObject volumeToJson(const Volume& volume)
{
    QJsonObject json{
        {key("identity"), identityToJson(volume.identity)},
        {key("geometry"), geometryToJson(volume.geometry)},
        {key("encoding"), encodingToJson(volume.encoding)},
        {key("unit"), volume.unit},
        {key("minimum"), volume.minimum},
        {key("maximum"), volume.maximum},
        {key("histogram"), histogramToJson(volume.histogram)},
        {key("window"),
            QJsonObject{{key("centre"), volume.defaultWindow.centre},
                {key("width"), volume.defaultWindow.width}}},
        {key("inverted"), volume.displayInverted},
        {key("sources"), sourcesToJson(volume.sources)},
        {key("path"), volume.sourcePath},
        {key("format"), volume.sourceFormat},
        {key("voxelsSha256"), QString::fromLatin1(volume.voxelsSha256)},
        {key("codesSha256"), QString::fromLatin1(volume.codesSha256)},
        {key("problems"), problemsToJson(volume.problems)},
    };
    if (!volume.repair.isEmpty())
        json[key("repair")] = volume.repair;
    if (volume.asIs) {
        json[key("asIs")] = QJsonObject{{key("geometry"), geometryToJson(volume.asIs->geometry)},
            {key("sources"), sourcesToJson(volume.asIs->sources)}};
    }
    return json;
}

std::optional<Volume> volumeFromJson(const QJsonObject& json)
{
    std::optional<VolumeGeometry> geometry = geometryFromJson(json[key("geometry")].toObject());
    const std::optional<VoxelEncoding> encoding =
        encodingFromJson(json[key("encoding")].toObject());
    if (!geometry || !encoding)
        return {};
    Volume volume;
    const QJsonObject identity = json[key("identity")].toObject();
    for (const IdentityField& field : identityFields)
        volume.identity.*field.text = identity[key(field.key)].toString();
    volume.geometry = *std::move(geometry);
    volume.encoding = *encoding;
    volume.unit = json[key("unit")].toString();
    volume.minimum = json[key("minimum")].toDouble();
    volume.maximum = json[key("maximum")].toDouble();
    volume.histogram = histogramFromJson(json[key("histogram")].toObject());
    const QJsonObject window = json[key("window")].toObject();
    volume.defaultWindow = {
        .centre = window[key("centre")].toDouble(), .width = window[key("width")].toDouble()};
    volume.displayInverted = json[key("inverted")].toBool();
    volume.sources = sourcesFromJson(json[key("sources")].toArray());
    volume.sourcePath = json[key("path")].toString();
    volume.sourceFormat = json[key("format")].toString();
    volume.voxelsSha256 = json[key("voxelsSha256")].toString().toLatin1();
    volume.codesSha256 = json[key("codesSha256")].toString().toLatin1();
    volume.problems = problemsFromJson(json[key("problems")].toArray());
    if (const QString repair = json[key("repair")].toString(); !repair.isEmpty()) {
        const std::optional<SeriesRepair> read = SeriesRepair::fromText(repair);
        if (!read)
            return {};
        volume.repair = repair;
        // A spacing that was given moves no voxel to another slice.
        if (read->withoutSpacing().isNone() && volume.sources.empty())
            return volume;
        const QJsonObject asIs = json[key("asIs")].toObject();
        std::optional<VolumeGeometry> slices = geometryFromJson(asIs[key("geometry")].toObject());
        std::vector<SourceSlice> sources = sourcesFromJson(asIs[key("sources")].toArray());
        if (!slices || sources.size() != std::size_t(slices->size.z)
            || !isGridOf(volume.geometry, *slices, repair))
            return {};
        volume.asIs = std::make_shared<const SeriesAsIs>(
            SeriesAsIs{.geometry = *std::move(slices), .sources = std::move(sources)});
    }
    const bool sensible =
        volume.sources.empty() || volume.sources.size() == std::size_t(volume.geometry.size.z);
    return sensible ? std::optional(std::move(volume)) : std::nullopt;
}

} // namespace core
