package mien;

/** A failed call: its status (see Status), the status's C name, and the first offending index or -1. */
public final class MienException extends RuntimeException {
    private static final long serialVersionUID = 1L;
    private final int status;
    private final long detailIndex;

    MienException(int status, long detailIndex, String message) {
        super(message);
        this.status = status;
        this.detailIndex = detailIndex;
    }

    public int status() { return status; }
    public long detailIndex() { return detailIndex; }
    public String statusName() { return Information.statusName(status); }
}
