// SPDX-License-Identifier: Apache-2.0
#include "core/nrrd/NrrdGeometry.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace core {

namespace {

using Vector = std::vector<double>;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

QList<QByteArray> words(const QByteArray& text)
{
    const QByteArray simple = text.simplified();
    return simple.isEmpty() ? QList<QByteArray>() : simple.split(' ');
}

/// Numbers apart by blanks, NaN among them; none if one is no number.
std::optional<Vector> numbers(const QByteArray& text)
{
    Vector values;
    for (const QByteArray& word : words(text)) {
        bool isNumber = false;
        const double value = word.toDouble(&isNumber);
        const bool isNan = word.toLower() == "nan";
        if (!isNumber && !isNan)
            return std::nullopt;
        values.push_back(isNan ? missing : value);
    }
    return values;
}

/// "(1,0,0) none (0,0,2)": one vector an axis, an empty one for "none".
std::optional<std::vector<Vector>> vectors(const QByteArray& text)
{
    std::vector<Vector> axes;
    qsizetype at = 0;
    while (at < text.size()) {
        if (text[at] == ' ' || text[at] == '\t') {
            ++at;
        } else if (text[at] == '(') {
            const qsizetype end = text.indexOf(')', at);
            if (end < 0)
                return std::nullopt;
            auto values = numbers(text.mid(at + 1, end - at - 1).replace(',', ' '));
            if (!values || values->empty())
                return std::nullopt;
            axes.push_back(std::move(*values));
            at = end + 1;
        } else if (text.mid(at, 4) == "none") {
            axes.emplace_back();
            at += 4;
        } else {
            return std::nullopt;
        }
    }
    return axes;
}

/// What is between quotation marks, or apart by blanks where there are none.
QList<QByteArray> quoted(const QByteArray& text)
{
    if (!text.contains('"'))
        return words(text);
    QList<QByteArray> found;
    const QList<QByteArray> parts = text.split('"');
    for (qsizetype part = 1; part < parts.size(); part += 2)
        found.append(parts[part].trimmed());
    return found;
}

double millimetresPer(const QByteArray& unit)
{
    const QByteArray name = unit.toLower();
    if (name == "m" || name == "meter" || name == "metre" || name == "meters")
        return 1000.0;
    if (name == "cm" || name == "centimeter" || name == "centimeters")
        return 10.0;
    if (name == "um" || name == "\xc2\xb5m" || name == "micron" || name == "micrometer"
        || name == "microns" || name == "micrometers")
        return 0.001;
    return 1.0;
}

/// How a space turns into LPS, by component.
struct Space {
    glm::dvec3 signs{1.0};
    bool ofPatient = true;
};

std::optional<Space> spaceNamed(QByteArray name)
{
    name = name.toLower();
    if (name.endsWith("-time"))
        name.chop(5);
    else if (name.size() == 4 && name.endsWith('t'))
        name.chop(1);
    if (name == "left-posterior-superior" || name == "lps")
        return Space{};
    if (name == "right-anterior-superior" || name == "ras")
        return Space{.signs = {-1.0, -1.0, 1.0}};
    if (name == "left-anterior-superior" || name == "las")
        return Space{.signs = {1.0, -1.0, 1.0}};
    if (name == "3d-right-handed" || name == "3dr" || name == "3d-left-handed" || name == "3dl")
        return Space{.ofPatient = false};
    return std::nullopt;
}

constexpr int mostAxes = 16;

/// One axis of the array, fastest first.
struct Axis {
    qint64 size = 0;
    bool spatial = true;
    std::optional<glm::dvec3> direction; ///< in the header's space
    double spacing = missing;
    double minimum = missing;
    double maximum = missing;
    bool nodes = false; ///< minimum and maximum are of centres, not of edges
    double unitMm = 1.0;
};

bool isSpatialKind(const QByteArray& kind)
{
    return kind == "domain" || kind == "space" || kind == "none" || kind.startsWith('?');
}

class GeometryReader {
public:
    GeometryReader(GridFile& grid, const NrrdHeader& header)
        : m_grid(grid)
        , m_header(header)
    {
    }

    Result<void> read();

private:
    [[nodiscard]] tl::unexpected<Error> refused(const Clause& reason) const
    {
        return failure(ErrorCode::FileUnreadable, m_grid.voxels.header, reason);
    }
    void caution(VolumeProblem::Kind kind, ProblemCode code)
    {
        m_grid.problems.push_back({.kind = kind, .said = {code}, .caution = true});
    }
    Result<void> readAxes();
    Result<void> readDirections();
    Result<void> readSpacings();
    Result<void> keepSpatialAxes();
    Result<void> placeBySpace();
    void placeBySpacings();
    void completeSlice();

    GridFile& m_grid;
    const NrrdHeader& m_header;
    std::vector<Axis> m_axes;
    std::optional<Space> m_space;
    bool m_directed = false;
};

Result<void> GeometryReader::readAxes()
{
    const auto dimension = wholeNumbers(m_header.field("dimension"));
    const auto sizes = wholeNumbers(m_header.field("sizes"));
    if (!dimension || dimension->size() != 1 || (*dimension)[0] < 1 || (*dimension)[0] > mostAxes)
        return refused(Clause::saying("its header names no dimension"));
    if (!sizes || qint64(sizes->size()) != (*dimension)[0])
        return refused(Clause::saying("its header does not name a size for each axis"));
    for (const qint64 size : *sizes) {
        if (size < 1)
            return refused(Clause::saying("its header names a size of %1", size));
        m_axes.push_back({.size = size});
    }
    return {};
}

Result<void> GeometryReader::readDirections()
{
    const QByteArray space = m_header.field("space");
    const auto dimension = wholeNumbers(m_header.field("spacedimension"));
    if (!space.isEmpty()) {
        m_space = spaceNamed(space);
        if (!m_space) {
            return failure(ErrorCode::UnsupportedFormat, m_grid.voxels.header,
                Clause::saying("its space '%1' is not one of the patient",
                    QString::fromLatin1(space.left(40))));
        }
    } else if (m_header.fields.contains("spacedimension")) {
        if (!dimension || dimension->size() != 1 || (*dimension)[0] < 1 || (*dimension)[0] > 4)
            return refused(Clause::saying("its header names no dimension of its space"));
        m_space = Space{.ofPatient = false};
    }
    const QByteArray text = m_header.field("spacedirections");
    if (text.isEmpty())
        return {};
    const auto directions = vectors(text);
    if (!directions || directions->size() != m_axes.size() || !m_space)
        return refused(Clause::saying("its header does not name a direction for each axis"));
    m_directed = true;
    for (std::size_t axis = 0; axis < m_axes.size(); ++axis) {
        const Vector& vector = (*directions)[axis];
        glm::dvec3 direction(0.0);
        for (std::size_t part = 0; part < std::min<std::size_t>(3, vector.size()); ++part)
            direction[int(part)] = vector[part];
        // Time is the fourth component of a space that has it.
        m_axes[axis].spatial =
            !vector.empty() && !(vector.size() > 3 && direction == glm::dvec3(0.0));
        if (m_axes[axis].spatial)
            m_axes[axis].direction = direction;
    }
    return {};
}

Result<void> GeometryReader::readSpacings()
{
    for (const auto& [name, part] : {std::pair("spacings", &Axis::spacing),
             std::pair("axismins", &Axis::minimum), std::pair("axismaxs", &Axis::maximum)}) {
        const QByteArray text = m_header.field(name);
        if (text.isEmpty())
            continue;
        const auto values = numbers(text);
        if (!values || values->size() != m_axes.size())
            return refused(Clause::saying(
                "its header does not have a number for each axis in '%1'", QLatin1String(name)));
        for (std::size_t axis = 0; axis < m_axes.size(); ++axis)
            m_axes[axis].*part = (*values)[axis];
    }
    const QList<QByteArray> kinds = words(m_header.field("kinds").toLower());
    QList<QByteArray> centres = words(m_header.field("centerings").toLower());
    if (centres.isEmpty())
        centres = words(m_header.field("centers").toLower());
    const QList<QByteArray> units = quoted(m_header.field("units"));
    for (std::size_t axis = 0; axis < m_axes.size(); ++axis) {
        Axis& one = m_axes[axis];
        const auto index = qsizetype(axis);
        if (!m_directed && index < kinds.size())
            one.spatial = isSpatialKind(kinds[index]);
        one.nodes = centres.value(index) == "node";
        one.unitMm = millimetresPer(units.value(index));
    }
    return {};
}

/// Axes of length 1 that are none of space, and those beyond the third, go; longer ones refuse the
/// file.
Result<void> GeometryReader::keepSpatialAxes()
{
    const auto spatial = [&] {
        return std::count_if(
            m_axes.begin(), m_axes.end(), [](const Axis& axis) { return axis.spatial; });
    };
    for (auto axis = m_axes.rbegin(); axis != m_axes.rend() && spatial() > 3; ++axis)
        axis->spatial = axis->spatial && axis->size > 1;
    for (auto axis = m_axes.rbegin(); axis != m_axes.rend() && spatial() > 3; ++axis)
        axis->spatial = false;
    for (std::size_t axis = 0; axis < m_axes.size(); ++axis) {
        if (m_axes[axis].spatial || m_axes[axis].size == 1)
            continue;
        return failure(ErrorCode::UnsupportedFormat, m_grid.voxels.header,
            axis == 0 ? Clause::saying("it holds %1 values per voxel", m_axes[axis].size)
                      : Clause::saying("it holds %1 volumes", m_axes[axis].size));
    }
    std::erase_if(m_axes, [](const Axis& axis) { return !axis.spatial; });
    if (m_axes.size() < 2)
        return failure(ErrorCode::UnsupportedFormat, m_grid.voxels.header,
            Clause::saying("it holds no slices"));
    return {};
}

Result<void> GeometryReader::placeBySpace()
{
    const Space space = m_space.value_or(Space{.ofPatient = false});
    const QList<QByteArray> units = quoted(m_header.field("spaceunits"));
    glm::dvec3 toLps = space.signs;
    for (int part = 0; part < 3; ++part)
        toLps[part] *= millimetresPer(units.value(part));
    glm::dmat4& affine = m_grid.geometry.indexToWorld;
    for (std::size_t axis = 0; axis < m_axes.size(); ++axis)
        affine[int(axis)] = glm::dvec4(toLps * *m_axes[axis].direction, 0.0);
    const QByteArray text = m_header.field("spaceorigin");
    if (text.isEmpty()) {
        m_grid.problems.push_back(
            {.kind = VolumeProblem::Kind::Other, .said = {ProblemCode::OriginAssumed}});
    } else {
        const auto origin = vectors(text);
        if (!origin || origin->size() != 1 || origin->front().empty())
            return refused(Clause::saying("its header does not name the space origin"));
        for (std::size_t part = 0; part < std::min<std::size_t>(3, origin->front().size()); ++part)
            affine[3][int(part)] = toLps[int(part)] * origin->front()[part];
    }
    if (!space.ofPatient) {
        caution(VolumeProblem::Kind::Other, ProblemCode::AxesAssumed);
    }
    return {};
}

void GeometryReader::placeBySpacings()
{
    glm::dmat4& affine = m_grid.geometry.indexToWorld;
    bool assumed = false;
    for (std::size_t axis = 0; axis < m_axes.size(); ++axis) {
        const Axis& one = m_axes[axis];
        const double steps = double(one.nodes ? one.size - 1 : one.size);
        double spacing = one.spacing;
        if (std::isnan(spacing) && steps > 0.0)
            spacing = (one.maximum - one.minimum) / steps;
        assumed = assumed || std::isnan(spacing);
        spacing = std::isnan(spacing) ? 1.0 : spacing;
        const double first = one.minimum + (one.nodes ? 0.0 : spacing / 2.0);
        affine[int(axis)] = glm::dvec4(0.0);
        affine[int(axis)][int(axis)] = one.unitMm * spacing;
        affine[3][int(axis)] = std::isnan(first) ? 0.0 : one.unitMm * first;
    }
    caution(VolumeProblem::Kind::Other, ProblemCode::AxesAssumed);
    if (assumed)
        caution(VolumeProblem::Kind::AssumedSpacing, ProblemCode::SpacingAssumed);
}

/// A picture gets the third axis that a volume needs.
void GeometryReader::completeSlice()
{
    if (m_axes.size() == 3)
        return;
    glm::dmat4& affine = m_grid.geometry.indexToWorld;
    const glm::dvec3 across = glm::cross(glm::dvec3(affine[0]), glm::dvec3(affine[1]));
    affine[2] = glm::dvec4(glm::normalize(across), 0.0);
    m_axes.push_back({.size = 1});
    caution(VolumeProblem::Kind::AssumedSpacing, ProblemCode::ThicknessAssumed);
}

Result<void> GeometryReader::read()
{
    for (const auto part : {&GeometryReader::readAxes, &GeometryReader::readDirections,
             &GeometryReader::readSpacings, &GeometryReader::keepSpatialAxes}) {
        if (const Result<void> done = (this->*part)(); !done)
            return done;
    }
    if (m_directed) {
        if (const Result<void> placed = placeBySpace(); !placed)
            return placed;
    } else {
        placeBySpacings();
    }
    completeSlice();
    const std::vector<qint64> sides{m_axes[0].size, m_axes[1].size, m_axes[2].size};
    if (const Result<void> sized = setGridSize(m_grid, sides); !sized)
        return sized;
    return checkGridAxes(m_grid.geometry, m_grid.voxels.header,
        m_directed ? Clause::saying("space directions") : Clause::saying("spacings"));
}

} // namespace

std::optional<std::vector<qint64>> wholeNumbers(const QByteArray& text)
{
    std::vector<qint64> values;
    for (const QByteArray& word : words(text)) {
        bool isNumber = false;
        values.push_back(word.toLongLong(&isNumber));
        if (!isNumber)
            return std::nullopt;
    }
    return values;
}

Result<void> setNrrdGeometry(GridFile& grid, const NrrdHeader& header)
{
    return GeometryReader(grid, header).read();
}

} // namespace core
