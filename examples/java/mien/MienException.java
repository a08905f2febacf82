package mien;

import java.nio.charset.StandardCharsets;

/** A failed call: its status, the status's name, and the first offending index or -1. */
public final class MienException extends RuntimeException {
    private static final long serialVersionUID = 1L;
    private final int status;
    private final long detailIndex;

    MienException(int status, long detailIndex, byte[] message) {
        super(new String(message, StandardCharsets.UTF_8));
        this.status = status;
        this.detailIndex = detailIndex;
    }

    public int status() { return status; }
    public long detailIndex() { return detailIndex; }
    public String statusName() { return new String(Native.statusName(status), StandardCharsets.UTF_8); }
}
