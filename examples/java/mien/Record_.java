package mien;

/** A value of several fields that is written into a C struct. */
interface Record_ {
    void fill(Call call, Memory at, int offset);
}
