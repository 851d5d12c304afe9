// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/growth/LeakPhantoms.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace test {

namespace {

constexpr int side = 96;
constexpr int outsideCode = 10000;
constexpr int insideCode = 11000;
constexpr double wallVoxels = 3.0; ///< voxels, at least
constexpr std::int64_t leastLeak = 20000;

struct Ball {
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};
struct Rod {
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0};
    double radiusFrom = 0.0;
    double radiusTo = 0.0;

    [[nodiscard]] glm::dvec3 at(double part) const { return from + part * (to - from); }
    [[nodiscard]] double radiusAt(double part) const
    {
        return radiusFrom + part * (radiusTo - radiusFrom);
    }
};

double distance(const glm::dvec3& place, const Ball& ball)
{
    return glm::length(place - ball.centre) - ball.radius;
}

double distance(const glm::dvec3& place, const Rod& rod)
{
    const glm::dvec3 along = rod.to - rod.from;
    const double part =
        std::clamp(glm::dot(place - rod.from, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::length(place - rod.at(part)) - rod.radiusAt(part);
}

struct Shape {
    std::vector<Ball> balls;
    std::vector<Rod> rods;

    [[nodiscard]] double distanceTo(const glm::dvec3& place) const
    {
        double least = 1e9;
        for (const Ball& ball : balls)
            least = std::min(least, distance(place, ball));
        for (const Rod& rod : rods)
            least = std::min(least, distance(place, rod));
        return least;
    }
};

double between(Random& random, double low, double high)
{
    return low + (high - low) * randomUnit(random);
}

glm::dvec3 randomDirection(Random& random)
{
    for (;;) {
        glm::dvec3 direction;
        for (int axis = 0; axis < 3; ++axis)
            direction[axis] = between(random, -1.0, 1.0);
        const double length = glm::length(direction);
        if (length > 0.1 && length <= 1.0)
            return direction / length;
    }
}

/// A body, and where a neck may leave it.
struct Body {
    const char* name = "";
    Shape shape;
    glm::ivec3 seed{0};
    glm::dvec3 exit{0.0};
    glm::dvec3 outwards{0.0, 1.0, 0.0};
};

glm::dvec3 upwards(Random& random, double lean)
{
    const double x = between(random, -lean, lean);
    const double z = between(random, -lean, lean);
    return glm::normalize(glm::dvec3(x, 1.0, z));
}

/// @param least radius where the neck leaves: wider than the neck
Body vessel(Random& random, double least)
{
    Body body{.name = "vessel"};
    double radius = between(random, least, 9.0);
    glm::dvec3 place{4.0, between(random, 18.0, 34.0), between(random, 30.0, 66.0)};
    body.seed = glm::ivec3(place + 0.5) + glm::ivec3(2, 0, 0);
    for (int part = 0; part < 4; ++part) {
        const double y = between(random, -6.0, 6.0);
        const glm::dvec3 next = place + glm::dvec3(22.0, y, between(random, -6.0, 6.0));
        const double further = std::clamp(radius + between(random, -1.2, 1.2), least, 9.0);
        body.shape.rods.push_back({place, next, radius, further});
        place = next;
        radius = further;
    }
    const Rod& rod = body.shape.rods[1 + random() % 2];
    const double part = between(random, 0.2, 0.8);
    body.outwards = upwards(random, 0.4);
    body.exit = rod.at(part) + body.outwards * rod.radiusAt(part);
    return body;
}

Body organ(Random& random)
{
    Body body{.name = "organ"};
    const double x = between(random, 36.0, 60.0);
    const double y = between(random, 20.0, 26.0);
    const Ball main{{x, y, between(random, 36.0, 60.0)}, between(random, 12.0, 17.0)};
    body.shape.balls.push_back(main);
    for (int lobe = 0; lobe < 3; ++lobe) {
        glm::dvec3 direction = randomDirection(random);
        direction.y = -0.5 * std::abs(direction.y);
        body.shape.balls.push_back(
            {main.centre + direction * main.radius * 0.8, between(random, 8.0, 13.0)});
    }
    body.seed = glm::ivec3(main.centre + randomDirection(random) * main.radius * 0.6);
    body.outwards = upwards(random, 0.5);
    body.exit = main.centre + body.outwards * main.radius;
    return body;
}

Body airways(Random& random, double least)
{
    Body body{.name = "airways"};
    const double trachea = between(random, 5.5, 7.5);
    body.seed = {48, 7, 48};
    const double x = between(random, 44.0, 52.0);
    const glm::dvec3 fork(x, 28.0, between(random, 44.0, 52.0));
    body.shape.rods.push_back({{48.0, 6.0, 48.0}, fork, trachea, trachea});
    for (const double left : {-1.0, 1.0}) {
        const double across = left * between(random, 18.0, 26.0);
        const double up = between(random, 6.0, 12.0);
        const glm::dvec3 end = fork + glm::dvec3(across, up, between(random, -10.0, 10.0));
        const double radius = std::max(least, trachea * between(random, 0.6, 0.8));
        body.shape.rods.push_back({fork, end, radius, radius});
        for (const double front : {-1.0, 1.0}) {
            const double further = left * between(random, 4.0, 10.0);
            const double higher = between(random, 2.0, 8.0);
            const glm::dvec3 tip =
                end + glm::dvec3(further, higher, front * between(random, 12.0, 20.0));
            const double thin = std::max(1.6, radius * between(random, 0.5, 0.8));
            body.shape.rods.push_back({end, tip, thin, thin});
        }
    }
    const Rod& rod = body.shape.rods[random() % 2 ? 1 : 4];
    const double part = between(random, 0.4, 0.8);
    body.outwards = upwards(random, 0.3);
    body.exit = rod.at(part) + body.outwards * rod.radiusAt(part);
    return body;
}

Body bodyOf(int number, Random& random, double least)
{
    switch (number % 3) {
    case 0:
        return vessel(random, least);
    case 1:
        return organ(random);
    default:
        return airways(random, least);
    }
}

LeakPhantom drawn(int number, bool leaks, Random& random)
{
    LeakPhantom phantom;
    const int radius = 1 + number / 3 % 3;
    const Body body = bodyOf(number, random, radius + 2.0);
    Shape blob;
    Rod neck;
    if (leaks) {
        phantom.neckRadius = radius;
        phantom.neckLength = randomInt(random, 2, 7);
        const double large = between(random, 17.0, 22.0);
        const glm::dvec3 far = body.exit + body.outwards * double(phantom.neckLength);
        const glm::dvec3 centre = far + body.outwards * (large - 1.0);
        blob.balls.push_back({centre, large});
        for (int lobe = 0; lobe < 2; ++lobe) {
            glm::dvec3 direction = randomDirection(random);
            direction.y = std::abs(direction.y);
            blob.balls.push_back({centre + direction * large * 0.7, between(random, 9.0, 15.0)});
        }
        neck = {
            body.exit - body.outwards * 2.0, far + body.outwards * 1.5, radius + 0.3, radius + 0.3};
        phantom.click = glm::ivec3(glm::round(centre + randomDirection(random) * large * 0.5));
    }
    phantom.body = body.name;
    phantom.seed = body.seed;
    phantom.lowCode = (outsideCode + insideCode) / 2;
    phantom.highCode = insideCode + 500;
    phantom.codes = constantVolume(glm::ivec3(side), outsideCode);
    phantom.leak = Bytes{phantom.codes.size, {}};
    phantom.leak.values.resize(phantom.codes.values.size());
    for (std::size_t i = 0; i < phantom.codes.values.size(); ++i) {
        const glm::dvec3 place(double(i % side), double(i / side % side), double(i / side / side));
        const double toBody = body.shape.distanceTo(place);
        double toBlob = leaks ? blob.distanceTo(place) : 1e9;
        if (leaks && toBody < wallVoxels)
            toBlob = std::max(toBlob, wallVoxels - toBody);
        const double toNeck = leaks ? distance(place, neck) : 1e9;
        const double inside = std::clamp(0.5 - std::min({toBody, toBlob, toNeck}), 0.0, 1.0);
        double noise = -1.5;
        for (int term = 0; term < 3; ++term)
            noise += randomUnit(random);
        phantom.codes.values[i] =
            std::uint16_t(outsideCode + (insideCode - outsideCode) * inside + 160.0 * noise);
        if (toBlob <= 0.0 && toBody > 0.0 && toNeck > 0.0) {
            phantom.leak.values[i] = 1;
            ++phantom.leakVoxels;
        }
    }
    return phantom;
}

} // namespace

LeakPhantom leakPhantom(int number, bool leaks)
{
    Random random(std::uint32_t(5000 + 2 * number + (leaks ? 1 : 0)));
    for (;;) {
        LeakPhantom phantom = drawn(number, leaks, random);
        if (!leaks)
            return phantom;
        // A blob may stick out of the volume; what is clicked at lies in it.
        if (phantom.leakVoxels >= leastLeak && phantom.leak.contains(phantom.click)
            && phantom.leak.at(phantom.click) == 1)
            return phantom;
    }
}

core::LoadedVolume loadedVolume(const LeakPhantom& phantom)
{
    core::LoadedVolume loaded;
    core::Volume& volume = loaded.volume;
    volume.identity.patientName = QStringLiteral("TEST^LEAK");
    volume.identity.modality = QStringLiteral("CT");
    volume.geometry.size = phantom.codes.size;
    for (int axis = 0; axis < 3; ++axis)
        volume.geometry.indexToWorld[3][axis] = -0.5 * (phantom.codes.size[axis] - 1);
    const auto [least, greatest] =
        std::minmax_element(phantom.codes.values.begin(), phantom.codes.values.end());
    volume.minimum = *least;
    volume.maximum = *greatest;
    volume.histogram = {volume.minimum, volume.maximum, std::vector<std::uint32_t>(64, 1)};
    volume.defaultWindow = {0.5 * (volume.minimum + volume.maximum), 1500.0};
    loaded.codes = phantom.codes.values;
    return loaded;
}

} // namespace test
