// SPDX-License-Identifier: Apache-2.0
#include "core/export/MeasurementsCsv.h"

#include "core/base/files/StagedFile.h"
#include "core/export/common/StatisticsText.h"

#include <QFile>

#include <array>
#include <charconv>

namespace core {

namespace {

/// As short as brings the same number back.
QByteArray shortest(double value)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), qsizetype(end.ptr - text.data())};
}

QByteArray shortest(const std::optional<double>& value)
{
    return value ? shortest(*value) : QByteArray();
}

QByteArray quoted(const QString& text)
{
    return '"' + noFormula(text).toUtf8().replace("\"", "\"\"") + '"';
}

/// The numbers of a line, in the order of their columns.
constexpr std::array numberNames{"length", "angleDegrees", "area", "volume", "longAxis",
    "shortAxis", "voxels", "mean", "standardDeviation", "minimum", "maximum"};

std::array<std::optional<double>, numberNames.size()> numbersOf(const Measured& measured)
{
    const MeasuredSize& size = measured.size;
    std::array<std::optional<double>, numberNames.size()> numbers{
        size.length, size.angleDegrees, size.area, size.volume, size.longAxis, size.shortAxis};
    if (const auto& values = measured.values) {
        numbers[6] = double(values->voxels);
        numbers[7] = values->mean;
        numbers[8] = values->deviation;
        numbers[9] = values->minimum;
        numbers[10] = values->maximum;
    }
    return numbers;
}

QByteArray pointsText(const Measurement& measurement, const VolumeGeometry& geometry)
{
    QByteArray text;
    for (const glm::dvec3& point : measurement.pointsLps) {
        const glm::dvec3 place = truePlace(geometry, point);
        if (!text.isEmpty())
            text += "; ";
        text += shortest(place.x) + ' ' + shortest(place.y) + ' ' + shortest(place.z);
    }
    return text;
}

/// The cells of a table in this form, without their quotation marks.
std::vector<std::vector<QByteArray>> cellsOf(const QByteArray& text)
{
    std::vector<std::vector<QByteArray>> lines;
    std::vector<QByteArray> line;
    QByteArray cell;
    bool inside = false;
    for (const char letter : text) {
        if (letter == '"') {
            // Two of them inside stand for one: the second opens the cell again.
            if (!inside && !cell.isEmpty())
                cell += '"';
            inside = !inside;
        } else if (inside || (letter != ',' && letter != '\r' && letter != '\n')) {
            cell += letter;
        } else if (letter != '\r') {
            line.push_back(cell);
            cell.clear();
            if (letter == '\n') {
                lines.push_back(line);
                line.clear();
            }
        }
    }
    return lines;
}

/// @return what differs between a table and what was measured; empty if nothing does
Clause differenceOf(const QByteArray& text, const std::vector<Measured>& all)
{
    const std::vector<std::vector<QByteArray>> lines = cellsOf(text);
    if (lines.size() != all.size() + 1)
        return Clause::saying("the number of measurements");
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto numbers = numbersOf(all[i]);
        for (std::size_t column = 0; column < lines[0].size(); ++column) {
            for (std::size_t k = 0; k < numberNames.size(); ++k) {
                if (lines[0][column] != numberNames[k])
                    continue;
                bool isNumber = false;
                const double number =
                    lines[i + 1].size() > column ? lines[i + 1][column].toDouble(&isNumber) : 0.0;
                if (isNumber != numbers[k].has_value() || (isNumber && number != *numbers[k]))
                    return Clause::saying("%1 of measurement %2", QLatin1String(numberNames[k]),
                        all[i].measurement.id);
            }
        }
    }
    return {};
}

} // namespace

QByteArray measurementsCsv(const std::vector<Measured>& all, const Volume& volume)
{
    QByteArray text = "number,kind,text,projected,sizesIn,valueUnit";
    for (const char* name : numberNames)
        text += QByteArray(",") + name;
    text += ",pointsLps\r\n";
    for (const Measured& each : all) {
        const Measurement& measurement = each.measurement;
        text += QByteArray::number(measurement.id) + ','
            + measurementWords[std::size_t(measurement.kind)] + ',' + quoted(measurement.text)
            + (measurement.projected ? ",yes," : ",no,") + (each.size.inVoxels ? "voxels," : "mm,")
            + quoted(volume.unit);
        for (const std::optional<double>& number : numbersOf(each))
            text += ',' + shortest(number);
        text += ',' + pointsText(measurement, volume.geometry) + "\r\n";
    }
    return text;
}

Result<void> exportMeasurements(
    const std::vector<Measured>& all, const Volume& volume, const QString& file, bool force)
{
    auto staged = StagedFile::create(file, force);
    if (!staged)
        return tl::unexpected(staged.error());
    const QByteArray text = measurementsCsv(all, volume);
    {
        QFile out(staged->path());
        if (!out.open(QIODevice::WriteOnly | QIODevice::Truncate) || out.write(text) != text.size()
            || !out.flush())
            return failure(ErrorCode::FileUnwritable, file, out.errorString());
    }
    QFile in(staged->path());
    if (!in.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, file, in.errorString());
    if (const Clause what = differenceOf(in.readAll(), all); !what.isEmpty())
        return failure(ErrorCode::ExportMismatch, file, what);
    in.close();
    return staged->commit();
}

} // namespace core
