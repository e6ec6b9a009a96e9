// Compresses as LibLZF does, which h5py and PCL use.

#ifndef LZF_H
#define LZF_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

// Repeats the longest that it finds behind the last three equal bytes.
inline std::vector<unsigned char> lzf(const unsigned char* data, std::size_t size)
{
  std::vector<unsigned char> result;
  std::map<std::array<unsigned char, 3>, std::size_t> places;
  std::size_t first = 0; // of those that are not yet stored
  const auto store_until = [&](std::size_t end) {
    for (; first < end; first += (std::min)(end - first, std::size_t(32)))
    {
      const std::size_t count = (std::min)(end - first, std::size_t(32));
      result.push_back(static_cast<unsigned char>(count - 1));
      result.insert(result.end(), data + first, data + first + count);
    }
  };
  for (std::size_t i = 0; i + 2 < size; ++i)
  {
    std::size_t& place =
      places.emplace(std::array<unsigned char, 3>{data[i], data[i + 1], data[i + 2]}, i).first->second;
    const std::size_t back = i - place;
    place = i;
    if (back == 0 || back > 8192)
      continue;
    std::size_t count = 3;
    while (count < 264 && i + count < size && data[i + count] == data[i + count - back])
      ++count;
    store_until(i);
    const std::size_t length = count - 2;
    result.push_back(static_cast<unsigned char>((std::min)(length, std::size_t(7)) << 5 | (back - 1) >> 8));
    if (length >= 7)
      result.push_back(static_cast<unsigned char>(length - 7));
    result.push_back(static_cast<unsigned char>((back - 1) & 255));
    first = i + count;
    i = first - 1;
  }
  store_until(size);
  return result;
}

#endif // LZF_H
