// SPDX-License-Identifier: Apache-2.0
#include "core/voxelfile/TextVoxels.h"

#include <array>
#include <charconv>
#include <cstring>
#include <string_view>

namespace core {

namespace {

/// Characters of a file, a piece at a time.
class Characters {
public:
    Characters(QFile& file, const Progress& progress)
        : m_file(file)
        , m_progress(progress)
    {
    }

    /// The next character; -1 at the end or when the work is no longer wanted.
    int next()
    {
        if (m_at == m_size) {
            m_size =
                m_progress.cancelled() ? 0 : m_file.read(m_buffer.data(), qint64(m_buffer.size()));
            m_at = 0;
            if (m_size <= 0) {
                m_size = 0;
                return -1;
            }
        }
        return static_cast<unsigned char>(m_buffer[std::size_t(m_at++)]);
    }

private:
    QFile& m_file;
    const Progress& m_progress;
    std::array<char, 65536> m_buffer;
    qint64 m_at = 0;
    qint64 m_size = 0;
};

bool isBlank(int character)
{
    return character == ' ' || (character >= '\t' && character <= '\r');
}

bool isBetween(int character)
{
    return isBlank(character) || character == ',';
}

template <class Stored> bool store(std::string_view word, char* to)
{
    if (word.starts_with('+'))
        word.remove_prefix(1);
    Stored value{};
    const char* end = word.data() + word.size();
    const std::from_chars_result read = std::from_chars(word.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end)
        return false;
    std::memcpy(to, &value, sizeof value);
    return true;
}

using Store = bool (*)(std::string_view word, char* to);

Store storeFor(ScalarType type)
{
    switch (type) {
    case ScalarType::Int8:
        return store<std::int8_t>;
    case ScalarType::UInt8:
        return store<std::uint8_t>;
    case ScalarType::Int16:
        return store<std::int16_t>;
    case ScalarType::UInt16:
        return store<std::uint16_t>;
    case ScalarType::Int32:
        return store<std::int32_t>;
    case ScalarType::UInt32:
        return store<std::uint32_t>;
    case ScalarType::Int64:
        return store<std::int64_t>;
    case ScalarType::UInt64:
        return store<std::uint64_t>;
    case ScalarType::Float32:
        return store<float>;
    case ScalarType::Float64:
        break;
    }
    return store<double>;
}

int digit(int character)
{
    if (character >= '0' && character <= '9')
        return character - '0';
    const int lower = character | 0x20;
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

} // namespace

tl::expected<bool, Clause> readTextVoxels(
    QFile& file, ScalarType type, std::span<char> into, const Progress& progress)
{
    // int8_t and uint8_t are characters to C++, but numbers to from_chars.
    const Store keep = storeFor(type);
    const std::size_t each = bytesPerScalar(type);
    Characters characters(file, progress);
    std::array<char, 64> word{};
    int character = characters.next();
    const auto toNextWord = [&] {
        while (isBetween(character))
            character = characters.next();
    };
    for (std::size_t at = 0; at < into.size(); at += each) {
        toNextWord();
        std::size_t length = 0;
        for (; character >= 0 && !isBetween(character); character = characters.next()) {
            if (length == word.size())
                return tl::unexpected(Clause::saying("its text holds words that are no numbers"));
            word[length++] = char(character);
        }
        if (length == 0)
            return tl::unexpected(QString());
        if (!keep({word.data(), length}, into.data() + at)) {
            return tl::unexpected(Clause::saying("its text holds '%1', which its type cannot",
                QString::fromLatin1(word.data(), qsizetype(length))));
        }
    }
    toNextWord();
    return character >= 0;
}

tl::expected<bool, Clause> readHexBytes(QFile& file, std::span<char> into, const Progress& progress)
{
    Characters characters(file, progress);
    const auto nextDigit = [&] {
        int character = characters.next();
        while (isBlank(character))
            character = characters.next();
        return character;
    };
    for (char& byte : into) {
        const int high = nextDigit();
        const int low = high < 0 ? -1 : nextDigit();
        if (low < 0)
            return tl::unexpected(QString());
        if (digit(high) < 0 || digit(low) < 0)
            return tl::unexpected(Clause::saying("it holds more than hexadecimal digits"));
        byte = char(digit(high) * 16 + digit(low));
    }
    return nextDigit() >= 0;
}

} // namespace core
