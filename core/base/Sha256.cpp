// SPDX-License-Identifier: Apache-2.0
#include "core/base/Sha256.h"

#include <openssl/evp.h>

#include <new>

namespace core {

struct Sha256::State {
    struct Freed {
        void operator()(EVP_MD_CTX* freed) const { EVP_MD_CTX_free(freed); }
    };
    std::unique_ptr<EVP_MD_CTX, Freed> context{EVP_MD_CTX_new()};
};

// It fails only for want of memory.
Sha256::Sha256()
    : m_state(std::make_unique<State>())
{
    if (!m_state->context || EVP_DigestInit_ex(m_state->context.get(), EVP_sha256(), nullptr) != 1)
        throw std::bad_alloc();
}

Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(const void* data, std::size_t size)
{
    EVP_DigestUpdate(m_state->context.get(), data, size);
}

std::array<std::uint8_t, 32> Sha256::take()
{
    std::array<std::uint8_t, 32> digest{};
    EVP_DigestFinal_ex(m_state->context.get(), digest.data(), nullptr);
    return digest;
}

QByteArray Sha256::takeHex()
{
    const std::array<std::uint8_t, 32> digest = take();
    return QByteArray(reinterpret_cast<const char*>(digest.data()), qsizetype(digest.size()))
        .toHex();
}

} // namespace core
