// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/common/Picture.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace bench {

Picture Picture::fromRgba(const glm::ivec2& size, const std::uint8_t* rgba)
{
    Picture picture{size, std::vector<std::uint8_t>(std::size_t(size.x) * std::size_t(size.y))};
    for (std::size_t i = 0; i < picture.luminance.size(); ++i) {
        const std::uint8_t* pixel = rgba + 4 * i;
        picture.luminance[i] = static_cast<std::uint8_t>(
            std::lround(0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]));
    }
    return picture;
}

void Picture::save(const std::string& file) const
{
    std::ofstream out(file, std::ios::binary);
    out << "P5\n" << size.x << ' ' << size.y << "\n255\n";
    out.write(reinterpret_cast<const char*>(luminance.data()),
        static_cast<std::streamsize>(luminance.size()));
}

Agreement compare(const Picture& a, const Picture& b, int background)
{
    if (a.size != b.size || a.luminance.empty())
        return {};
    double both = 0.0;
    double either = 0.0;
    double difference = 0.0;
    for (std::size_t i = 0; i < a.luminance.size(); ++i) {
        const bool inA = a.luminance[i] > background;
        const bool inB = b.luminance[i] > background;
        both += inA && inB ? 1.0 : 0.0;
        either += inA || inB ? 1.0 : 0.0;
        difference += std::abs(int(a.luminance[i]) - int(b.luminance[i]));
    }
    if (either == 0.0)
        return {};
    return {both / either, difference / 255.0 / double(a.luminance.size())};
}

} // namespace bench
